"""Rival methods for courses over time, each as its own documentation uses it, simulated freely."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.real_rigs.folders import Array
from benchmarks.real_rigs.rows import LOST, Course

FEWEST = 12  # samples of a course from which it is of use to a method with lags
WIDEST = 10  # samples that are missing in one place and still bridged; more divide a course


@dataclass(frozen=True)
class Scale:
    """Inputs and output are brought to zero mean and unit deviation by the fitted rows."""

    mean: Array
    size: Array

    @staticmethod
    def of(courses: Sequence[Course]) -> Scale:
        """The scale of some courses; the output is the last column."""
        table = np.concatenate([np.column_stack([c.inputs, c.measured]) for c in courses])
        size = table.std(axis=0)
        return Scale(table.mean(axis=0), np.where(size > 0, size, 1.0))

    def scaled(self, course: Course) -> tuple[Array, Array]:
        """Inputs (n, m) and output (n,)."""
        table = (np.column_stack([course.inputs, course.measured]) - self.mean) / self.size
        return table[:, :-1], table[:, -1]

    def output(self, y: Array) -> Array:
        """The output in its own unit."""
        return np.asarray(y * self.size[-1] + self.mean[-1])


@dataclass(frozen=True)
class Model:
    """A fitted model: a free run from (u, first samples of y), how many of these it needs, how many numbers it has."""

    simulate: Callable[[Array, Array], Array]
    lags: int
    count: int


Fitter = Callable[[list[tuple[Array, Array]], float], Model]


def narx(degree: int, lags: int, terms: int | None, outputs: bool = True) -> Fitter:
    """SysIdentPy's FROLS with a polynomial basis; samples of several runs are put together without their seams.

    ``terms``: how many; None: as many as the information criterion asks for. Without ``outputs`` it has lags of the
    inputs alone (NFIR).
    """

    def fit(data: list[tuple[Array, Array]], _: float) -> Model:
        from sysidentpy.basis_function import Polynomial
        from sysidentpy.model_structure_selection import FROLS, ofr_base
        from sysidentpy.parameter_estimation import LeastSquares
        from sysidentpy.utils.information_matrix import build_lagged_matrix

        inputs = data[0][0].shape[1]
        kind = ("NARMAX" if outputs else "NFIR") if inputs else "NAR"
        model = FROLS(
            order_selection=terms is None,
            n_terms=terms,
            n_info_values=25,
            info_criteria="bic",
            ylag=lags,
            xlag=[list(range(1, lags + 1))] * inputs if inputs > 1 else lags,
            basis_function=Polynomial(degree=degree),
            model_type=kind,
            estimator=LeastSquares(),
        )

        def seamless(x: Array, y: Array, xlag: object, ylag: object, model_type: str) -> Array:
            parts = [
                np.asarray(
                    build_lagged_matrix(u if inputs else None, v[:, None], xlag, ylag, model_type)
                )
                for u, v in data
            ]
            return np.concatenate([p if i == 0 else p[lags:] for i, p in enumerate(parts)])

        ofr_base.build_lagged_matrix = seamless
        y = np.concatenate([v if i == 0 else v[lags:] for i, (_, v) in enumerate(data)])[:, None]
        x = np.concatenate([u if i == 0 else u[lags:] for i, (u, _) in enumerate(data)])
        model.fit(X=x if inputs else None, y=y)

        def simulate(u: Array, first: Array) -> Array:
            begun = first[:, None]
            if inputs:
                return np.asarray(model.predict(X=u, y=begun))[:, 0]
            return np.asarray(model.predict(y=begun, forecast_horizon=len(u)))[: len(u), 0]

        return Model(simulate, lags, len(model.theta))

    return fit


def network(units: int, lags: int, seed: int, outputs: bool = True) -> Fitter:
    """scikit-learn's multi-layer perceptron on lagged inputs and outputs, or on the inputs alone."""

    def features(u: Array, y: Array, i: int) -> Array:
        return np.concatenate([u[i - lags : i + 1].ravel(), y[i - lags : i] if outputs else y[:0]])

    def fit(data: list[tuple[Array, Array]], _: float) -> Model:
        from sklearn.neural_network import MLPRegressor

        rows = np.array([features(u, y, i) for u, y in data for i in range(lags, len(y))])
        target = np.concatenate([y[lags:] for _, y in data])
        net = MLPRegressor(
            hidden_layer_sizes=(units,),
            activation="tanh",
            solver="lbfgs",
            max_iter=1000,
            random_state=seed,
        )
        net.fit(rows, target)
        (first, last), (a, b) = net.coefs_, net.intercepts_

        def simulate(u: Array, begun: Array) -> Array:
            y = np.concatenate([begun, np.zeros(len(u) - len(begun))])
            for i in range(lags, len(u)):
                y[i] = (np.tanh(features(u, y, i) @ first + a) @ last + b)[0]
            return np.asarray(y)

        return Model(simulate, lags, sum(w.size for w in (first, last, a, b)))

    return fit


def sindy(threshold: float) -> Fitter:
    """PySINDy's sparse equations of degree two."""

    def fit(data: list[tuple[Array, Array]], step: float) -> Model:
        import pysindy as ps
        from scipy.integrate import solve_ivp

        inputs = data[0][0].shape[1]
        model = ps.SINDy(
            feature_library=ps.PolynomialLibrary(degree=2), optimizer=ps.STLSQ(threshold=threshold)
        )
        controls = [u for u, _ in data] if inputs else None
        model.fit([y[:, None] for _, y in data], t=step, u=controls)

        def simulate(u: Array, begun: Array) -> Array:
            time = step * np.arange(len(u))

            def rate(t: float, y: Array) -> Array:
                held = np.array([[np.interp(t, time, v) for v in u.T]]) if inputs else None
                rates: Array = np.asarray(model.predict(np.clip(y, -50, 50)[None, :], u=held))[0]
                return rates

            done = solve_ivp(
                rate, (0, time[-1]), begun[:1], t_eval=time, max_step=step, method="RK23", rtol=1e-2
            )
            out = np.full(len(u), np.nan)
            out[: len(done.t)] = done.y[0]
            return out

        return Model(simulate, 1, int(np.count_nonzero(model.coefficients())))

    return fit


def _of_both(outputs: bool) -> str:
    return "" if outputs else ", inputs alone"


NARX = {
    f"degree {d}, {k} lags, {n or 'BIC'} terms{_of_both(o)}": narx(d, k, n, o)
    for d, k, n, o in itertools.product((1, 2), (2, 4), (None, 5, 10, 20), (True, False))
}
NETWORK = {
    f"{n} units, {k} lags, seed {s}{_of_both(o)}": network(n, k, s, o)
    for n, k, s, o in itertools.product((16, 32), (2, 5), (0, 1, 2), (True, False))
}
SINDY = {f"threshold {z}": sindy(z) for z in (0.001, 0.01, 0.1)}
SHELF: dict[str, dict[str, Fitter]] = {"NARX": NARX, "network": NETWORK, "SINDy": SINDY}


@dataclass(frozen=True)
class Fitted:
    """A method with the size that it chose."""

    size: str
    count: int
    predicted: dict[str, dict[str, Array]]


def run_method(
    sizes: dict[str, Fitter], courses: Mapping[str, Sequence[Course]], step: float
) -> Fitted:
    """Chooses the size by what is held back, fits all rows with it and simulates every course."""
    even = [part.even(step) for c in courses["fitted"] for part in measured_parts(c)]
    scale = Scale.of(even)
    kept, back = _held_back(even)
    if not even[0].inputs.shape[1]:
        sizes = {name: fit for name, fit in sizes.items() if not name.endswith(_of_both(False))}
    errors = {name: _error_of(fit, kept, back, scale, step) for name, fit in sizes.items()}
    best, model = _first_stable(
        sizes, sorted(errors, key=lambda name: errors[name]), even, scale, step
    )
    predicted = {
        r: {c.name: free_run(model, c, scale, step) for c in own} for r, own in courses.items()
    }
    return Fitted(best, model.count, predicted)


def measured_parts(course: Course) -> list[Course]:
    """What is measured of a course, divided where many samples are missing, for nothing to be learned from a bridge."""
    there = np.flatnonzero(~np.isnan(course.measured))
    if len(there) == len(course.measured):
        return [course]
    parts = np.split(there, np.flatnonzero(np.diff(there) > WIDEST) + 1)
    return [
        Course(
            course.name,
            course.time[rows],
            course.inputs[rows],
            course.measured[rows],
            course.score_from,
        )
        for first, last in ((part[0], part[-1] + 1) for part in parts)
        if len(rows := np.arange(first, last)) >= FEWEST
    ]


def _first_stable(
    sizes: dict[str, Fitter],
    order: Sequence[str],
    even: Sequence[Course],
    scale: Scale,
    step: float,
) -> tuple[str, Model]:
    """The best size whose free run does not leave the fitted rows by their own range; else the best of all."""
    first: tuple[str, Model] | None = None
    for name in order:
        try:
            model = sizes[name]([scale.scaled(c) for c in even], step)
        except (ValueError, ArithmeticError, IndexError, TypeError, np.linalg.LinAlgError):
            continue
        first = first or (name, model)
        errors = [np.nanmax(np.abs(free_run(model, c, scale, step) - c.measured)) for c in even]
        if max(errors) < np.ptp(np.concatenate([c.measured for c in even])):
            return name, model
    if first is None:
        raise ArithmeticError("no size of the method could be fitted")
    return first


def free_run(model: Model, course: Course, scale: Scale, step: float) -> Array:
    """The course at its own rows: NaN in the first samples, which the model was given."""
    even = course.even(step)
    u, y = scale.scaled(even)
    out = np.full(len(y), np.nan)
    if len(y) > model.lags:
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            out = np.asarray(model.simulate(u, y[: model.lags]), dtype=float)
    out = scale.output(np.nan_to_num(out, nan=1e9, posinf=1e9, neginf=-1e9))
    values = np.interp(course.time, even.time, out)
    return np.where(
        course.time < even.time[min(model.lags, len(even.time) - 1)] - 1e-12, np.nan, values
    )


def _held_back(even: Sequence[Course]) -> tuple[list[Course], Course]:
    if len(even) > 1:
        return list(even[:-1]), even[-1]
    (one,) = even
    cut = max(2 * len(one.time) // 3, min(FEWEST, len(one.time) - 4))
    return [
        Course(one.name, one.time[:cut], one.inputs[:cut], one.measured[:cut], one.score_from)
    ], one


def _error_of(
    fit: Fitter, kept: Sequence[Course], back: Course, scale: Scale, step: float
) -> float:
    try:
        model = fit([scale.scaled(c) for c in kept], step)
        values = free_run(model, back, scale, step)
    except (ValueError, ArithmeticError, IndexError, TypeError, np.linalg.LinAlgError):
        return np.inf
    error = (values - back.measured)[~np.isnan(values)]
    value = float(np.sqrt(np.mean(error**2)))
    return value if np.isfinite(value) else LOST
