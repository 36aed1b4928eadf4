"""Where a run begins: stated, measured from its first samples, estimated, or eliminated from a fit."""

from pam_cosim.starts.chosen_starts import StartChoice, starts_are_open
from pam_cosim.starts.eliminated_starts import EliminatedStarts
from pam_cosim.starts.initial_state import initial_state, measured_initial_state, state_trajectory
from pam_cosim.starts.probe import StartProbe
from pam_cosim.starts.run_start import InitialState, measured_signals, start_time

__all__ = [
    "EliminatedStarts",
    "InitialState",
    "StartChoice",
    "StartProbe",
    "initial_state",
    "measured_initial_state",
    "measured_signals",
    "start_time",
    "starts_are_open",
    "state_trajectory",
]
