"""Friction that grows with the speed. Positive forces oppose contraction."""

from __future__ import annotations

from rig.effect import Effect, State, law


@law
class ThickeningFluid(Effect):
    """A dashpot whose suspension thickens when sheared: c v (1 + r (v/v_0)^4)/(1 + (v/v_0)^4), r above 1.

    It is thin in slow motion, r times as thick beyond v_0. Source: X. Z. Zhang, W. H. Li, X. L. Gong, The rheology of
    shear thickening fluid (STF) and the dynamic performance of an STF-filled damper, Smart Mater. Struct. 17 (2008)
    035027; the rational law is reasoned.
    """

    c: float = 100.0  # N s/m
    v_0: float = 0.03  # m/s
    r: float = 4.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        fast = min(abs(v) / self.v_0, 1e3) ** 4
        return self.c * v * (1 + self.r * fast) / (1 + fast)


@law
class MeteringOrifices(Effect):
    """A shock absorber whose holes the piston covers one after another: c v |v|/(1 - x/x_e), at most ten times.

    The drop over holes of area A goes with (v/A)^2, and A with the root of the way left, which would slow a free mass
    down evenly. Source: J. C. Dixon, The Shock Absorber Handbook (2007), on position-sensitive orifices.
    """

    c: float = 2e3  # N s2/m2, at rest
    x_e: float = 0.1  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * abs(v) / max(1 - x / self.x_e, 0.1)
