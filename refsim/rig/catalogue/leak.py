"""Gas that gets out."""

from __future__ import annotations

from math import pi

from rig.effect import Effect, law
from rig.flow import P_ATM, T_ATM, mass_flow


@law
class OrificeLeak(Effect):
    """A hole to ambient, compressible flow through C_d pi d^2/4."""

    form = "orifice"
    diameter: float = 0.1e-3  # m
    c_d: float = 0.7

    def leak(self, p: float, temperature: float) -> float:
        area = self.c_d * pi / 4 * self.diameter**2
        return mass_flow(area, p, temperature, P_ATM, T_ATM)


@law
class LaminarLeak(Effect):
    """A laminar leak, mass flow = conductance times gauge pressure."""

    form = "laminar"
    conductance: float = 2.0e-11  # kg/(s Pa)

    def leak(self, p: float, temperature: float) -> float:
        return self.conductance * (p - P_ATM)
