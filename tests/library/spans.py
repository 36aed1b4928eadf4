"""How near an effect's law, as compiled, comes to another law when its coefficients are free within their bounds."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import casadi as ca
import numpy as np
from scipy.optimize import least_squares

from pam_cosim.fmu import build_source
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Inputs, Simulator
from tests.library.ode import Model
from tests.library.shelf import BENCH, on_bench, qualified

Array = np.ndarray


class Law:
    """A local variable of the isotonic bench with an effect, as a function of its states, inputs and coefficients.

    Args:
        effect: name of the effect.
        local: name of the variable.
        at: values (n,) of states and inputs by name [SI]; the others keep their values at the start.
        weight: factors (n,) on all values.
    """

    def __init__(
        self, effect: str, local: str, at: Mapping[str, Array | float], weight: Array | float = 1.0
    ) -> None:
        self._weight = weight
        composition = on_bench(effect, BENCH)
        with TemporaryDirectory() as folder:
            model = Model(composition.name, composition.text, Path(folder))
        ode = model.ode
        self.names = composition.parameters[effect]
        self.interface = model.interface
        self._p = model.parameters()
        law = ode.locals[list(model.interface.locals).index(local)]
        x = _columns([s.name for s in ode.states], model.initial(self._p), at)
        u = _columns(list(model.interface.inputs), model.inputs(), at)
        values = ca.Function("values", model.arguments, [law]).map(x.shape[1])
        p = ca.MX.sym("p", len(self._p))
        self._values = ca.Function("law", [p], [values(0, x, u, p)])
        self._slopes = self._values.jacobian()

    def __call__(self, **own: float) -> Array:
        """Values (n,) with these parameters, by the last part of their names."""
        return np.asarray(self._values(self._changed(own))).ravel() * self._weight

    def slopes(self, **own: float) -> Array:
        """Derivatives (n, parameters) by the effect's own parameters."""
        at = self._changed(own)
        jacobian = np.asarray(self._slopes(at, self._values(at)))
        mine = jacobian[:, [list(self.interface.parameters).index(n) for n in self.names]]
        return mine * np.reshape(self._weight, (-1, 1))

    def _changed(self, own: Mapping[str, float]) -> Array:
        p = self._p.copy()
        for i, name in enumerate(self.interface.parameters):
            if (short := name.rpartition(".")[2]) in own and name in self.names:
                p[i] = own[short]
        return p

    def misses(self, target: Array, of: Array | None = None) -> float:
        """Rms of what is left of ``target`` (n,) after least squares, by the rms of ``of`` (default ``target``)."""
        short = [n.rpartition(".")[2] for n in self.names]
        return misses(
            lambda own: self(**own),
            target,
            coefficients(self.interface, self.names),
            target if of is None else of,
            lambda own: self.slopes(**{k: own[k] for k in short}),
        )


def _columns(names: Sequence[str], start: Array, at: Mapping[str, Array | float]) -> Array:
    size = max(np.size(v) for v in at.values())
    return np.array(
        [np.broadcast_to(at.get(name, v), size) for name, v in zip(names, start, strict=True)]
    )


Coefficients = dict[str, tuple[float, float, float, float]]


def coefficients(interface: Interface, names: Sequence[str]) -> Coefficients:
    """Minimum, maximum, start and nominal size by the last part of the name."""
    by_name = {}
    for name in names:
        v = interface.parameters[name]
        assert v.min is not None and v.max is not None and v.start is not None
        by_name[name.rpartition(".")[2]] = (v.min, v.max, v.start, v.nominal or v.max - v.min)
    return by_name


def misses(
    law: Callable[[dict[str, float]], Array],
    target: Array,
    own: Coefficients,
    of: Array,
    slopes: Callable[[dict[str, float]], Array] | None = None,
) -> float:
    """As ``Law.misses``, for any function of an effect's coefficients.

    Coefficients whose bounds are positive and a hundredfold apart are searched by their logarithm, as a fit does it.
    """
    low, high, start, scale = np.array(list(own.values())).T
    log = (low > 0) & (high >= 100 * np.maximum(low, 1e-300))
    size = float(np.sqrt(np.mean(of**2) * len(of)))

    def to_z(value: Array) -> Array:
        return np.where(log, np.log(np.where(log, value, 1.0)), value / scale)

    def to_own(z: Array) -> dict[str, float]:
        value = np.where(log, np.exp(np.where(log, z, 0.0)), z * scale)
        return dict(zip(own, np.clip(value, low, high).tolist(), strict=True))

    def residuals(z: Array) -> Array:
        return (law(to_own(z)) - target) / size

    def jacobian(z: Array) -> Array:
        assert slopes is not None
        values = to_own(z)
        return slopes(values) * np.where(log, list(values.values()), scale) / size

    best = np.inf
    zs = [to_z(v) for v in (low, high, start)]
    reach = zs[1] - zs[0]
    starts = [
        np.clip(zs[2] + np.where(log, 0.0, 0.1) * reach * d, zs[0], zs[1])
        for d in ((0, -1, 1) if slopes else (0,))
    ]
    for z in starts:
        z = np.clip(z, zs[0] + 1e-6 * reach, zs[1] - 1e-6 * reach)
        solution = least_squares(
            residuals,
            z,
            jacobian if slopes else "2-point",
            bounds=(zs[0], zs[1]),
            ftol=1e-10,
            diff_step=1e-3,
        )
        best = min(best, float(np.sqrt(2 * solution.cost)))
    return best


HARNESS = """model Harness "An effect on an imposed path under an imposed pressure"
  input Real x_wanted(unit="m", start=0); input Real p_wanted(unit="Pa", start=1e5);
  output Real f(unit="N") = effect.f;
  inner PneumaticMuscle.Ambient ambient;
  {effect} effect(L0=0.24, D0=0.02, turns=2, t_wall=0.254e-3);
  PneumaticMuscle.Mechanics.Components.Fixed ceiling(s0=0.24);
  PneumaticMuscle.Mechanics.Components.ImposedPosition hand(s_wanted=x_wanted, tau=2e-4);
  PneumaticMuscle.Pneumatics.Components.Regulator regulator(p_wanted=p_wanted);
equation
  connect(effect.flange_a, hand.flange); connect(effect.flange_b, ceiling.flange); connect(effect.port, regulator.port);
end Harness;"""

DRIVE = """model Harness "A drive of a valve"
  input Real u(unit="A", start=0); output Real y(unit="A") = drive.y[1];
  {effect} drive(u={{u, 0}});
end Harness;"""


_GEOMETRY = ("L0", "D0", "turns", "t_wall")


def course_misses(
    text: str,
    effect: str,
    part: str,
    times: Array,
    inputs: dict[str, Array],
    target: Array,
    weight: Array | float = 1.0,
) -> float:
    """As ``Law.misses``, for the course of a harness's only output under ``inputs``, each (times,)."""
    with Simulator(
        build_source("Harness", text.format(effect=qualified(effect)), brief=True)
    ) as simulator:
        names = [n for n in simulator.interface.parameters if n.rpartition(".")[0] == part]
        own = coefficients(
            simulator.interface, [n for n in names if n.rpartition(".")[2] not in _GEOMETRY]
        )
        output = next(iter(simulator.interface.outputs))
        drive = Inputs(times, inputs, "linear")

        def law(values: dict[str, float]) -> Array:
            changed = {f"{part}.{name}": value for name, value in values.items()}
            run = simulator.run(times, parameters=changed, inputs=drive, tolerance=1e-7)
            return np.asarray(run.values[output]) * weight

        return misses(law, target * weight, own, target * weight)
