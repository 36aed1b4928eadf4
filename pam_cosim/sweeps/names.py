"""Names in results of sweeps that are not those of the model."""

FAILURE = "failure"  # why a run failed; empty where it did not
RUN = "run"  # its number
TIME = "time"
