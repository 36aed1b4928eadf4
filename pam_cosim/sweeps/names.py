"""Names that results of sweeps have beside those of the model."""

FAILURE = "failure"  # why a run failed; empty where it did not
RUN = "run"  # its number
TIME = "time"
