"""FMUs driven step by step, alone (``Rig``) and coupled."""

from pam_cosim.cosimulation.rig import Readings, Rig, RigState

__all__ = ["Readings", "Rig", "RigState"]
