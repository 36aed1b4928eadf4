"""How valves follow their command, and what they let through."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.schedule import Currents

State = Sequence[float]


@dataclass(frozen=True)
class SaturatingCoil(Effect):
    """The coil's inductance falls as its iron saturates, L/(1 + (u/u_s)^2): u' = (command - u)(1 + (u/u_s)^2)/tau.

    Source: N. D. Vaughan, J. B. Gamble, The modeling and simulation of a proportional solenoid valve, J. Dyn. Syst.
    Meas. Control 118 (1996) 120, on the inductance that depends on the current.
    """

    family = "valve_dynamics"
    form = "saturating_coil"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.1  # s
    u_s: float = 0.2  # A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        return (command - u) * (1 + (u / self.u_s) ** 2) / self.tau

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@dataclass(frozen=True)
class PilotStage(Effect):
    """The spool moves by what flows through a pilot orifice, the root of what it is off: u' = sqrt(u_r |e|) sign(e)/T.

    e = command - u, smooth below 2 mA. The spool arrives in a finite time, 2 T after a step of u_r.
    Source: H. E. Merritt, Hydraulic Control Systems (1967), chapter 7, on two-stage valves.
    """

    family = "valve_dynamics"
    form = "pilot_stage"
    atol: ClassVar[tuple[float, ...]] = (1e-8, 1e-8)
    time: float = 0.04  # s, T
    u_r: float = 0.35  # A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        off = command - u
        return sqrt(self.u_r) * off / sqrt(sqrt(off * off + 4e-6)) / self.time

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


_PERRY = (-0.1002, 0.8415, -3.9, 4.6001, -1.6827)  # coefficients of r to r^5
_PERRY_AT_VACUUM = 0.8414


@dataclass(frozen=True)
class SharpEdge(Effect):
    """The jet of a sharp edge contracts the more, the less it is choked: area times 1 - s (1 - C_d(r)/C_d(0)).

    r is the ratio of pressures, C_d falls from 0.84 to 0.60; s = 1 is Perry's orifice.
    Source: J. A. Perry, Critical flow through sharp-edged orifices, Trans. ASME 71 (1949) 757, with the polynomial of
    D. McCloy, H. R. Martin, Control of Fluid Power (1980).
    """

    family = "valve_area"
    form = "sharp_edge"
    s: float = 0.5

    def valve_factor(self, p_up: float, p_down: float) -> float:
        r = min(p_down / p_up, 1.0)
        change = sum(c * r ** (k + 1) for k, c in enumerate(_PERRY))
        return 1 + self.s * change / _PERRY_AT_VACUUM


@dataclass(frozen=True)
class CloggedSilencer(Effect):
    """A silencer of area A_s in series behind the exhaust valve: A/sqrt(1 + (A/A_s)^2), the inlet valve as it was.

    Restrictions in series add by their inverse squares (P. Beater, Pneumatic Drives, 2007, section 5.3).
    """

    family = "valve_area"
    form = "silencer"
    area: float = 5e-7  # m2, A_s

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return areas[0], areas[1] / sqrt(1 + (areas[1] / self.area) ** 2)
