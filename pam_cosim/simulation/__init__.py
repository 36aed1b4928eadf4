""".fmu and inputs -> Trajectory."""

from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.inputs import Inputs
from pam_cosim.simulation.simulator import Simulator, SolverStatistics
from pam_cosim.simulation.trajectory import Trajectory

__all__ = ["Inputs", "RunFailure", "Simulator", "SolverStatistics", "Trajectory"]
