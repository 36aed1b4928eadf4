""".fmu and inputs -> Trajectory."""

from pam_cosim.simulation.abilities import Abilities
from pam_cosim.simulation.driver import Settle
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.inputs import Inputs
from pam_cosim.simulation.isolated import IsolatedSimulator
from pam_cosim.simulation.simulator import Simulator, SolverStatistics
from pam_cosim.simulation.trajectory import Trajectory

AnySimulator = Simulator | IsolatedSimulator

__all__ = [
    "Abilities",
    "AnySimulator",
    "Inputs",
    "IsolatedSimulator",
    "RunFailure",
    "Settle",
    "Simulator",
    "SolverStatistics",
    "Trajectory",
]
