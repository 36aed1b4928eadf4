"""Heat through the films and layers of the muscle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import P_ATM, T_ATM
from rig.seen.heat import EnergyGas

State = Sequence[float]


@dataclass(frozen=True)
class RenewedFilm(EnergyGas):
    """The film thickens by diffusion and flow renews it: h s^(-1/2) with s' = (1 - s)/tau - s |m_net|/m_0.

    s, the second state, is the square of the film's thickness, at most that of still gas.
    Source: P. V. Danckwerts, Significance of liquid-film coefficients in gas absorption, Ind. Eng. Chem. 43 (1951)
    1460: the coefficient goes as the square root of the rate at which the surface is renewed.
    """

    form = "renewed_film"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    tau: float = 1.0  # s
    m_0: float = 3e-5  # kg

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 1.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        renewed = sqrt(now.net_mass_flow**2 + 1e-16) / self.m_0
        return now.net_mass_flow, (1 - q[1]) / self.tau - q[1] * renewed

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h / sqrt(max(q[1], 1e-3)))


@dataclass(frozen=True)
class EnclosedConvection(EnergyGas):
    """Still gas conducts, warm or cold gas turns over: h (1 + ((p/p_atm)^2 |T - T_atm|/dT)^(1/4)).

    The Rayleigh number of an enclosure goes with the density squared and the difference of temperatures.
    Source: S. W. Churchill, H. H. S. Chu, Int. J. Heat Mass Transf. 18 (1975) 1049, the laminar term.
    """

    form = "enclosed_convection"
    difference: float = 20.0  # K, dT: convection then doubles what still gas of ambient pressure conducts

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        away = sqrt((temperature - T_ATM) ** 2 + 1e-2)
        return self._through(self.h * (1 + ((p / P_ATM) ** 2 * away / self.difference) ** 0.25))


@dataclass(frozen=True)
class PressedLayers(Effect):
    """A bladder that loses its heat to the braid, and the better, the harder it is pressed: between (p/1 bar)^0.95.

    States: temperatures of bladder and braid; 5 % of 1 bar is left of the contact without gauge pressure.
    Source: M. G. Cooper, B. B. Mikic, M. M. Yovanovich, Thermal contact conductance, Int. J. Heat Mass Transf. 12
    (1969) 279, for the exponent.
    """

    family = "wall_heat"
    form = "pressed_layers"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.3  # J/K, of the bladder
    ratio: float = 2.0  # capacity of the braid by that of the bladder
    between: float = 0.1  # W/K, at 1 bar
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        pressed = (0.05 + max(now.p_gauge, 0.0) / 1e5) ** 0.95
        passed = self.between * pressed * (q[0] - q[1])
        outward = passed - self.g_out * (q[1] - T_ATM)
        return (-now.heat_to_gas - passed) / self.capacity, outward / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class SoakedHeat(Effect):
    """What the fibres lose by rubbing, on each other and on the bladder, soaks through the bladder: two lags of tau/2.

    States: heat [W] that has come half and all the way. Reasoned as conduction through a wall in two lumps; friction
    heats in both directions.
    """

    family = "friction_heat"
    form = "soaked"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    share: float = 1.0
    tau: float = 0.3  # s
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        rubbed = max(now.p_gauge, 0.0) * (self.crossing * now.v**2 + self.covered * abs(now.v))
        return (self.share * rubbed - q[0]) * 2 / self.tau, (q[0] - q[1]) * 2 / self.tau

    def heat(self, q: State) -> float:
        return q[1]
