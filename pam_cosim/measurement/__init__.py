"""The measurement room: a folder with ``experiment.toml`` and CSV files becomes a ``DataSet``."""

from pam_cosim.measurement.condensing import condensed
from pam_cosim.measurement.cuts import Cut, Moment, Overrides, overrides_of
from pam_cosim.measurement.data_set import ROLES, DataSet, Role, Run
from pam_cosim.measurement.experiment import error_in
from pam_cosim.measurement.free_parameter import FreeParameter, Prior, Transform
from pam_cosim.measurement.further_run import further_run, rows_of
from pam_cosim.measurement.noise import complete_noise, record_step
from pam_cosim.measurement.read import read_data_set
from pam_cosim.measurement.recording import Recording, read_recording
from pam_cosim.measurement.rig_columns import RigColumn, rig_columns
from pam_cosim.measurement.signal import Signal, StatedSignal
from pam_cosim.measurement.start import START_MODES, Start, StartMode
from pam_cosim.measurement.text_file import any_text
from pam_cosim.measurement.white_noise import estimate_noise
from pam_cosim.measurement.write import write_data_set

__all__ = [
    "Cut",
    "DataSet",
    "FreeParameter",
    "Moment",
    "Overrides",
    "Prior",
    "ROLES",
    "Recording",
    "RigColumn",
    "Role",
    "Run",
    "START_MODES",
    "Signal",
    "Start",
    "StartMode",
    "StatedSignal",
    "Transform",
    "any_text",
    "complete_noise",
    "condensed",
    "error_in",
    "estimate_noise",
    "further_run",
    "overrides_of",
    "record_step",
    "read_data_set",
    "read_recording",
    "rig_columns",
    "rows_of",
    "write_data_set",
]
