"""Thermometers that come late."""

from __future__ import annotations

from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import P_ATM, T_ATM

_SHELLS = 4
_PIECES = 4


@law
class BlownThermocouple(Effect):
    """The lag is shorter while gas flows: tau/(1 + (|m|/m_0)^(1/2))."""

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.3  # s
    m_0: float = 3e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        quick = 1 + (abs(now.net_mass_flow) / self.m_0) ** 0.5
        return ((now.temperature - q[0]) * quick / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@law
class TwoPartThermocouple(Effect):
    """A part of the reading follows with tau, the other with 6 tau."""

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.1  # s
    share: float = 0.6  # of the quick part

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.temperature - q[0]) / self.tau, (now.temperature - q[1]) / (6 * self.tau)

    def reading(self, q: State, temperature: float) -> float:
        return self.share * q[0] + (1 - self.share) * q[1]


@law
class DenseAirThermocouple(Effect):
    """The lag is shorter in dense gas: tau (p_atm/p)^a, as the film on the wire goes with Re^a.

    Source: V. T. Morgan, The overall convective heat transfer from smooth circular cylinders, Adv. Heat Transf. 11
    (1975) 199, with exponents of about 0.3 to 0.6.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s
    a: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) * ((now.p_gauge + P_ATM) / P_ATM) ** self.a / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@law
class StemThermocouple(Effect):
    """The stem conducts to the fitting at ambient: tau q' = T - q - c (q - T_atm), so a part of each change is lost.

    A fin with its root at ambient temperature. Source: R. J. Moffat, Gas temperature measurement, in Temperature: Its
    Measurement and Control in Science and Industry 3 (1962), on conduction error.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s
    c: float = 0.1

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0] - self.c * (q[0] - T_ATM)) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@law
class PottedBead(Effect):
    """A junction in the middle of a ball of potting, into which heat diffuses: four shells, the middle one is read.

    tau is radius squared over diffusivity (3 s for 0.6 mm of epoxy); slow changes come tau/6 late.
    Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids (1959), chapter 9, in finite volumes.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _SHELLS
    tau: float = 1.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * _SHELLS

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        edges = [k / _SHELLS for k in range(_SHELLS + 1)]
        inward = [0.0]
        inward += [
            r * r * _SHELLS * (b - a) for r, a, b in zip(edges[1:-1], q[:-1], q[1:], strict=True)
        ]
        inward.append(2 * _SHELLS * (now.temperature - q[-1]))
        volumes = [(b**3 - a**3) / 3 for a, b in zip(edges[:-1], edges[1:], strict=True)]
        gained = zip(inward[1:], inward[:-1], volumes, strict=True)
        return tuple((outer - inner) / volume / self.tau for outer, inner, volume in gained)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@law
class BuoyantBead(Effect):
    """Around the bead the gas conducts and rises: T' = (T_gas - T)/tau (1 + a ((p/p_atm)^2 |T_gas - T|/10 K)^(1/4)).

    Source: T. Yuge, Experiments on heat transfer from spheres, J. Heat Transf. 82 (1960) 214: Nu = 2 + 0.43 Ra^(1/4).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.3  # s
    a: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        off = now.temperature - q[0]
        rayleigh = (1 + now.p_gauge / P_ATM) ** 2 * (off * off + 1e-4) ** 0.5 / 10
        return (off / self.tau * (1 + self.a * rayleigh**0.25),)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@law
class ThreePoles(Effect):
    """The thermocouple's amplifier filters out the mains by three equal poles, and what it shows is late.

    Source: data sheets of thermocouple converters; three poles in series are the usual critically damped filter
    (U. Tietze, C. Schenk, Electronic Circuits, 2008, chapter 13).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,) * 3
    tau: float = 0.06  # s, of each pole

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 3

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        before = (now.temperature, q[0], q[1])
        return tuple((a - b) / self.tau for a, b in zip(before, q, strict=True))

    def reading(self, q: State, temperature: float) -> float:
        return q[2]


@law
class LongWire(Effect):
    """A bare wire from the fitting to its junction: tau T_i' = T_gas - T_i + k (T_(i-1) - 2 T_i + T_(i+1)).

    Four pieces from the root, which is at ambient temperature, to the tip; k is the square of the fin's decay length by
    that of a piece. Source: D. Bradley, K. J. Matthews, Measurement of high gas temperatures with fine wire
    thermocouples, J. Mech. Eng. Sci. 10 (1968) 299, in finite volumes.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _PIECES
    tau: float = 0.15  # s
    k: float = 1.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * _PIECES

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        # along the wire towards the tip; from the root to the first middle it is half as far
        along = [2 * self.k * (T_ATM - q[0])]
        along += [self.k * (a - b) for a, b in zip(q[:-1], q[1:], strict=True)]
        along.append(0.0)
        pieces = zip(q, along[:-1], along[1:], strict=True)
        return tuple((now.temperature - t + came - went) / self.tau for t, came, went in pieces)

    def reading(self, q: State, temperature: float) -> float:
        return q[-1]


@law
class Compensated(Effect):
    """A thermocouple whose amplifier makes up for a part of its lag: q + r tau q', q' = (T - q)/tau.

    Source: C. E. Shepard, I. Warshawsky, Electrical techniques for compensation of thermal time lag of thermocouples,
    NACA TN 2703 (1952): the lag in use is never that for which the network was set.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.2  # s
    r: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0] + self.r * (temperature - q[0])


@law
class Recess(Effect):
    """The bead sits in a recess, whose gas flow renews: T_r' = (T - T_r)/tau (1 + |m|/m_0), the bead behind tau/5.

    States: recess and bead. Reasoned: diffusion renews a recess at rest, and flow past it in proportion.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.4  # s
    m_0: float = 4e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        renewed = 1 + abs(now.net_mass_flow) / self.m_0
        return (now.temperature - q[0]) * renewed / self.tau, (q[0] - q[1]) * 5 / self.tau

    def reading(self, q: State, temperature: float) -> float:
        return q[1]


@law
class BesselFilter(Effect):
    """The thermocouple's amplifier has a Bessel filter of second order: tau^2 q'' = T - q - sqrt(3) tau q'.

    States: reading and its rate. Source: U. Tietze, C. Schenk, Electronic Circuits (2008), chapter 13.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-5)
    tau: float = 0.1  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return q[1], ((now.temperature - q[0]) / self.tau - 3**0.5 * q[1]) / self.tau

    def reading(self, q: State, temperature: float) -> float:
        return q[0]
