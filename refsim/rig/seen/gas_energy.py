"""The gas's temperature from the balances of mass and energy, and the films at the wall."""

from __future__ import annotations

from math import exp, sqrt
from typing import ClassVar

from rig.catalogue.gas_energy import EnergyGas
from rig.effect import Now, Rest, State, law
from rig.flow import P_ATM, T_ATM

_LATENT = 2.5e6  # J/kg
_SETTLING = 0.05  # s, in which droplets grow or vanish


@law
class FreeConvectionGas(EnergyGas):
    """The film grows with the temperature difference: h (0.5 + 0.5 (|T - T_atm|/10 K)^(1/3))."""

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(
            self.h * (0.5 + 0.5 * (((temperature - T_ATM) ** 2 + 0.01) / 100) ** (1 / 6))
        )


@law
class DenseGas(EnergyGas):
    """The film grows with the density: h (p/p_atm)^a."""

    a: float = 0.6

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h * (p / P_ATM) ** self.a)


@law
class ConductiveGas(EnergyGas):
    """The film of still gas is as thick as the muscle: h D0/D (T/T_atm)^0.8. Second state: the contraction.

    Nu = h D/k is a constant without forced flow; air's conductivity grows about as T^0.8.
    Source: F. P. Incropera, D. P. DeWitt, Fundamentals of Heat and Mass Transfer, chapter 8 and table A.4.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, now.v

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        at_rest = self.fibre_squared - self.length**2
        narrower = sqrt(at_rest / (self.fibre_squared - (self.length - q[1]) ** 2))
        return self._through(self.h * narrower * (temperature / T_ATM) ** 0.8)


@law
class WoschniGas(EnergyGas):
    """The film of an engine's cylinder: h (p/p_atm)^0.8 (T/T_atm)^-0.53 (1 + |w|/w_0)^0.8, w the speed of the end.

    The second state is w: it follows the speed with 20 ms, as the gas that it stirs does.
    Source: G. Woschni, SAE paper 670931 (1967), without the factor of the bore.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    w_0: float = 0.03  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.v - q[1]) / 0.02

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        stirred = (1 + sqrt(q[1] ** 2 + 1e-8) / self.w_0) ** 0.8
        return self._through(self.h * (p / P_ATM) ** 0.8 * (temperature / T_ATM) ** -0.53 * stirred)


@law
class RenewedFilm(EnergyGas):
    """The film thickens by diffusion and flow renews it: h s^(-1/2) with s' = (1 - s)/tau - s |m_net|/m_0.

    s, the second state, is the square of the film's thickness, at most that of still gas.
    Source: P. V. Danckwerts, Significance of liquid-film coefficients in gas absorption, Ind. Eng. Chem. 43 (1951)
    1460: the coefficient goes as the square root of the rate at which the surface is renewed.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    tau: float = 1.0  # s
    m_0: float = 3e-5  # kg

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 1.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        renewed = sqrt(now.net_mass_flow**2 + 1e-16) / self.m_0
        return now.net_mass_flow, (1 - q[1]) / self.tau - q[1] * renewed

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h / sqrt(max(q[1], 1e-3)))


@law
class EnclosedConvection(EnergyGas):
    """Still gas conducts, warm or cold gas turns over: h (1 + ((p/p_atm)^2 |T - T_atm|/dT)^(1/4)).

    The Rayleigh number of an enclosure goes with the density squared and the difference of temperatures.
    Source: S. W. Churchill, H. H. S. Chu, Int. J. Heat Mass Transf. 18 (1975) 1049, the laminar term.
    """

    difference: float = (
        20.0  # K, dT: convection then doubles what still gas of ambient pressure conducts
    )

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        away = sqrt((temperature - T_ATM) ** 2 + 1e-2)
        return self._through(self.h * (1 + ((p / P_ATM) ** 2 * away / self.difference) ** 0.25))


@law
class DecayingTurbulence(EnergyGas):
    """Flow in or out makes turbulence, which decays by itself: u' = b |m_net| - u^2/l; film h + h_1 (u/1 m/s)^0.8.

    Second state: u. Left alone, it falls as l/t. Source: H. Tennekes, J. L. Lumley, A First Course in Turbulence
    (1972), section 3.2, on the decay; the exponent is that of turbulent flow over walls.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-7)
    h_1: float = 15.0  # W/(m2 K)
    eddy: float = 0.02  # m, l
    b: float = 2e6  # m/(s kg)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, self.b * abs(now.net_mass_flow) - q[1] * abs(q[1]) / self.eddy

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h + self.h_1 * (q[1] ** 2 + 1e-8) ** 0.4)


@law
class GasSpring(EnergyGas):
    """Heat leads the temperature: K (T_w - T) + c K (T_b - T), where gas near the wall follows, T_b' = (T - T_b)/tau.

    Second state: T_b. Compressed gas gives off more heat than its mean temperature says while that still rises.
    Source: A. A. Kornhauser, J. L. Smith, The effects of heat transfer on gas spring performance, J. Energy Resour.
    Technol. 115 (1993) 70, whose complex Nusselt number is this for one time constant.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-6)
    c: float = 1.0
    tau: float = 0.3  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, rest.temperature)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.temperature - q[1]) / self.tau

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h) * (1 + self.c)

    def wall_temperature(self, q: State, outside: float) -> float:
        return (outside + self.c * q[1]) / (1 + self.c)


@law
class InletJet(EnergyGas):
    """The inlet's jet stirs the gas and venting does not: h + h_1 (m_jet/0.1 g/s)^(2/3), where it dies away in tau.

    Second state: the jet. Source: H. Martin, Heat and mass transfer between impinging gas jets and solid surfaces, Adv.
    Heat Transf. 13 (1977) 1, with exponents about 2/3.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h_1: float = 30.0  # W/(m2 K)
    tau: float = 0.1  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (max(now.net_mass_flow, 0.0) - q[1]) / self.tau

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h + self.h_1 * ((q[1] ** 2 + 1e-16) / 1e-8) ** (1 / 3))


@law
class EndPlates(EnergyGas):
    """Heat goes through the wall and, besides, into the metal end plugs, which stay at ambient temperature.

    The plugs' conductance does not change with contraction. Source: first law with two paths of heat.
    """

    plates: float = 0.03  # W/K

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return 0.0, self.plates * (temperature - T_ATM)


@law
class FoggingGas(EnergyGas):
    """Air with some water: what is beyond saturation becomes fog in 50 ms, and its latent heat warms the gas.

    Second state: the fog by mass of gas, thinned by what flows in. Saturation by Magnus (WMO-No. 8, annex 4.B); source
    of the balance: R. R. Rogers, M. K. Yau, A Short Course in Cloud Physics (1989), chapter 2.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-9)
    water: float = 3e-3  # kg by kg of gas

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h)

    def _growth(self, q: State, p: float, temperature: float) -> float:
        celsius = max(temperature - 273.15, -80.0)
        vapour = 611.2 * exp(17.62 * celsius / (243.12 + celsius))
        beyond = self.water - 0.622 * vapour / max(p - vapour, 1e3)
        fog = (beyond + sqrt(beyond * beyond + 1e-10)) / 2
        return (fog - q[1]) / _SETTLING

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return 0.0, -_LATENT * q[0] * self._growth(q, p, temperature)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        growth = self._growth(q, now.p_gauge + P_ATM, now.temperature)
        return now.net_mass_flow, growth - q[1] * max(now.net_mass_flow, 0.0) / q[0]
