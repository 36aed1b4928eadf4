""".fmu and a point or a measurement -> LinearModel: linear models, frequency responses, observers."""

from pam_cosim.analysis.frequency_response import FrequencyResponse
from pam_cosim.analysis.linear import LinearModel, Mode
from pam_cosim.analysis.linear_models import LinearModels
from pam_cosim.analysis.observation import Observation
from pam_cosim.analysis.operating_point import OperatingPoint

__all__ = [
    "FrequencyResponse",
    "LinearModels",
    "LinearModel",
    "Mode",
    "Observation",
    "OperatingPoint",
]
