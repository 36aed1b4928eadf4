"""FMUs driven step by step, alone (``Rig``) and coupled (``System``)."""

from pam_cosim.cosimulation.coupled_run import CoupledRun
from pam_cosim.cosimulation.network import CouplingFailure
from pam_cosim.cosimulation.parts import (
    Connection,
    Controller,
    CoupledFmu,
    Port,
    connect,
    controller,
)
from pam_cosim.cosimulation.rig import Readings, Rig, RigState
from pam_cosim.cosimulation.sampling import ControllerError
from pam_cosim.cosimulation.system import System, couple_values

__all__ = [
    "Connection",
    "Controller",
    "ControllerError",
    "CoupledRun",
    "CouplingFailure",
    "CoupledFmu",
    "Port",
    "Readings",
    "Rig",
    "RigState",
    "System",
    "connect",
    "controller",
    "couple_values",
]
