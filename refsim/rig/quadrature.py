"""Filling and emptying times of a polytropic vessel by quadrature: the separable ODE solved as t(p).

dm/dt = flow(p, T(p)) with m ~ p^(1/n) gives t = integral of m(p)/(n p flow) dp, without an ODE solver. With
p = p_far - (p_far - p_from) exp(-s) the integrand over s stays finite up to equal pressures.
"""

from __future__ import annotations

from math import exp, log

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

from rig.flow import P_ATM, R_CRITICAL, R_LAMINAR
from rig.integrate import Array
from rig.schedule import Currents
from rig.tank import Ports, Vessel

_S_END = 16.0  # 1e-7 of the pressure step is left: nearer, 1 - r has lost its digits


class Approach:
    """A vessel on its way from p_from to the pressure p_far on the other side (both Pa gauge).

    currents [A] are constant. Times are exact to about 1e-8 relative.
    """

    def __init__(
        self,
        vessel: Vessel,
        ports: Ports,
        p_from: float,
        p_far: float,
        currents: Currents = (0.0, 0.0),
    ) -> None:
        self.vessel, self.ports, self.currents = vessel, ports, currents
        self.far, self.step = p_far + P_ATM, p_far - p_from
        ratios = (R_CRITICAL, 1 / R_CRITICAL, R_LAMINAR, 1 / R_LAMINAR)
        fractions = [(1 - ratio) * self.far / self.step for ratio in ratios]
        self.kinks = sorted(-log(f) for f in fractions if exp(-_S_END) < f < 1)

    def _slowness(self, s: float) -> float:
        gap = self.step * exp(-s)
        p = self.far - gap
        rate = sum(flow for flow, _ in self.ports(p, self.vessel.temperature(p), self.currents))
        return gap * self.vessel.mass(p) / (self.vessel.n * p * rate)

    def _time(self, s_from: float, s_to: float) -> float:
        low, high = min(s_from, s_to), max(s_from, s_to)
        edges = [low, *(s for s in self.kinks if low < s < high), high]
        pieces = zip(edges[:-1], edges[1:], strict=True)
        total = sum(
            quad(self._slowness, a, b, epsabs=1e-12, epsrel=1e-8, limit=200)[0] for a, b in pieces
        )
        return float(total) if s_to >= s_from else -float(total)

    def time_to(self, p: float) -> float:
        """Time [s] until gauge pressure p [Pa], which lies between p_from and p_far (exclusive)."""
        return self._time(0.0, log(self.step / (self.far - P_ATM - p)))

    def pressures(self, times: Array) -> Array:
        """Gauge pressures [Pa] at increasing times [s], shape (times,): t(p) = time solved for p."""
        result, s, t_known = [], 0.0, 0.0
        for t in times.tolist():
            wait = t - t_known
            if s < _S_END and wait > 0:
                if self._time(s, _S_END) <= wait:
                    s = _S_END
                else:
                    s = brentq(
                        lambda end, start=s, wait=wait: self._time(start, end) - wait,
                        s, _S_END, xtol=1e-11, rtol=1e-13,
                    )  # fmt: skip
                t_known = t
            result.append(self.far - P_ATM - (self.step * exp(-s) if s < _S_END else 0.0))
        return np.array(result)
