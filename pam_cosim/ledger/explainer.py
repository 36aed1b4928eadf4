"""Explanations of the samples by unknown inputs of a model: smoothing problem, grid, and separable inputs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.ledger.augmented import AugmentedModel, UnknownInput
from pam_cosim.ledger.grid import Grid, make_grid
from pam_cosim.ledger.model import Model
from pam_cosim.ledger.radau import further_nodes, integrate
from pam_cosim.ledger.smoothed_models import SmoothedModel
from pam_cosim.ledger.smoother import smooth
from pam_cosim.ledger.smoothing_problem import (
    Point,
    SmoothingProblem,
    unknown_sizes,
    with_free,
)
from pam_cosim.measurement import DataSet
from pam_cosim.model.domain import Domain

_SPACING = 0.04  # [s], of the nodes of a run of middle length, at most
_FEWEST_NODES = 50  # of a short run
_MOST_NODES = 400  # of a long run, which limits the run time
_ACCURACY = 2e-4  # of the range of a state, in one step
_REFINEMENTS = 3  # of a grid, at most
_GRID_ERROR = 0.2  # sd of a sample: a finer grid must change the outputs by more
_PARALLEL_TERMS = 1e-6  # squared sine, below which two terms act alike and are one
_RANGE_IN_DEVIATIONS = 5.0  # sd of the prior of a free parameter


class Explainer:
    """Explains the samples of a data set by augmented models.

    Args:
        data: the measurement.
        values: parameters [SI], as a fit of the model found them.
        models: the augmented ones; the first has an unknown input in each balance.
        domain: of the library.
        deadline: of ``time.monotonic`` [s], at which a smoother gives up with a TimeoutError.

    Attributes:
        signals: that are fitted and that the model gives; ``sigma`` (S,) their noise.
        free: parameters that are estimated along, from ``start`` on, between ``low`` and ``high`` (Q,) [SI].
        notes: sentences on what could not be done or separated; this grows.
        same: by balance, others whose terms do the same in this model; this grows.

    Raises:
        InputError: the model has no states.
    """

    def __init__(
        self,
        data: DataSet,
        values: Mapping[str, float],
        models: Sequence[AugmentedModel],
        domain: Domain,
        deadline: float = math.inf,
    ) -> None:
        self.deadline = deadline
        self.data, self.values, self.models, self.domain = data, values, models, domain
        interface = models[0].ode.interface
        if not models[0].ode.states:
            raise InputError(
                f"{data.model} has no states: it has no balances for a ledger", data.model
            )
        self.signals = [n for n, s in data.signals.items() if s.fitted and n in interface.outputs]
        self.sigma = np.array([data.signals[n].sigma for n in self.signals], dtype=float)
        self.free = [n for n in data.fit if n in interface.parameters]
        self.low = np.array([data.fit[n].min for n in self.free])
        self.high = np.array([data.fit[n].max for n in self.free])
        defaults = {n: v.start or 0.0 for n, v in interface.parameters.items()}
        begin = {n: f.start for n, f in data.fit.items() if f.start is not None}
        self.start = np.clip(
            [float({**defaults, **begin, **values}[n]) for n in self.free], self.low, self.high
        )
        self.acts = np.array(
            [
                [n not in run.parameters and f"{n}@{run.name}" not in values for n in self.free]
                for run in data.runs
            ],
            dtype=bool,
        ).reshape(len(data.runs), len(self.free))
        self.notes: list[str] = []
        self.grids: dict[int, Grid] = {}
        self.same: dict[str, tuple[str, ...]] = {}

    def problem(
        self,
        augmented: AugmentedModel,
        unknown_inputs: Sequence[UnknownInput],
        states: tuple[Array, Array] | None = None,
    ) -> tuple[SmoothingProblem, tuple[Array, Array]]:
        """The smoothing problem of a model, and its states at nodes (N, n) and inside steps (M, n) [SI].

        Args:
            augmented: the model.
            unknown_inputs: those that are estimated.
            states: (N, n) and (M, n) of the model without unknown inputs; None: they are integrated.
        """
        grid = self._grid(augmented)
        model = Model(augmented.ode, [u.parameter for u in unknown_inputs], self.free, self.signals)
        prior_deviation = (self.high - self.low) / _RANGE_IN_DEVIATIONS
        none = SmoothingProblem(
            model,
            grid,
            self.sigma,
            self.start,
            prior_deviation,
            self.low,
            self.high,
            self.acts,
            np.ones(model.states),
            np.ones(len(unknown_inputs)),
        )
        states = states or integrate(model, grid, none.parameters(self.start))
        ranges = np.ptp(states[0], axis=0)
        size = np.where(ranges > 0, ranges, np.maximum(np.max(np.abs(states[0]), axis=0), 1e-6))
        p = none.parameters(self.start)
        unknown_size = unknown_sizes(none, states[0], p)
        return replace(none, size=size, unknown_size=unknown_size), states

    def _spacing(self) -> float:
        """Between the nodes of a grid [s]."""
        longest = max(float(run.time[-1] - run.time[0]) for run in self.data.runs)
        if longest >= _SPACING * _MOST_NODES:
            return longest / _MOST_NODES
        return min(_SPACING, longest / _FEWEST_NODES)

    def _grid(self, augmented: AugmentedModel) -> Grid:
        """The grid of an augmented model, fine enough for the model alone: a finer one changes nothing."""
        key = self.models.index(augmented)
        if key not in self.grids:
            self.grids[key] = self._refined_grid(augmented)
        return self.grids[key]

    def _refined_grid(self, augmented: AugmentedModel) -> Grid:
        args = (
            augmented.ode,
            self.data,
            self.data.runs,
            self.values,
            self.signals,
            self._spacing(),
        )
        grid, model = make_grid(*args), Model(augmented.ode, [], self.free, self.signals)
        p = with_free(grid.parameters, model, self.start, self.acts)
        states = integrate(model, grid, p)
        extra_nodes = [np.zeros(0) for _ in grid.runs]
        for _ in range(_REFINEMENTS):
            new = further_nodes(model, grid, p, states, _ACCURACY)
            extra_nodes = [np.union1d(a, b) for a, b in zip(extra_nodes, new, strict=True)]
            finer = make_grid(*args, extra_nodes)
            states_of_finer = integrate(model, finer, p)
            if self._same_outputs(model, (grid, states[0]), (finer, states_of_finer[0]), p):
                break
            grid, states = finer, states_of_finer
        return grid

    def _same_outputs(
        self, model: Model, coarse: tuple[Grid, Array], fine: tuple[Grid, Array], p: Array
    ) -> bool:
        """Whether the signals agree where both grids have nodes, far below the noise."""
        outputs = []
        for grid, x in (coarse, fine):
            run = grid.run_of_node
            slopes = model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p[run])
            outputs.append((run, grid.time, slopes.value[:, model.states :]))
        (run, time, coarse_values), (run_of_fine, time_of_fine, fine_values) = outputs
        common = np.zeros(len(time_of_fine), dtype=bool)
        for r in range(len(coarse[0].runs)):
            common[run_of_fine == r] = np.isin(time_of_fine[run_of_fine == r], time[run == r])
        difference = (coarse_values - fine_values[common]) / self.sigma
        return bool(np.sqrt(np.mean(difference**2)) < _GRID_ERROR)

    def explain(
        self,
        augmented: AugmentedModel,
        states: tuple[Array, Array] | None = None,
    ) -> SmoothedModel | None:
        """The model with all unknown inputs that act and can be separated; None without any, or if it breaks down."""
        problem, states = self.problem(augmented, augmented.unknown_inputs, states)
        distinct_inputs = self._distinct(augmented, problem, states[0])
        if not distinct_inputs:
            return None
        problem, _ = self.problem(augmented, distinct_inputs, states)
        start = Point(*states, np.zeros((len(states[0]), len(distinct_inputs))), self.start)
        try:
            smoothed = smooth(problem, start, self.deadline)
            return SmoothedModel(augmented, problem, distinct_inputs, tuple(self.free), smoothed)
        except (np.linalg.LinAlgError, ValueError):
            self.notes.append(
                "the balances could not be opened: the simulation fails near the measured trajectory"
            )
            return None

    def _distinct(
        self, augmented: AugmentedModel, problem: SmoothingProblem, x: Array
    ) -> tuple[UnknownInput, ...]:
        """The unknown inputs that act, one of each set that the model cannot separate."""
        if not augmented.unknown_inputs:
            return ()
        grid, distinct = problem.grid, list[int]()
        p = grid.parameters[grid.run_of_node]
        slopes = problem.model.everything(
            grid.time, x, grid.node_inputs, grid.node_delayed, p
        ).by_unknown_input
        slopes = slopes / np.maximum(np.max(np.abs(slopes), axis=(0, 2), keepdims=True), 1e-300)
        places = [
            self.domain.place(unknown_input.balance) for unknown_input in augmented.unknown_inputs
        ]
        for i in sorted(range(len(places)), key=lambda i: (places[i], i)):
            if not problem.unknown_size[i] > 0:
                continue
            equivalent = next(
                (k for k in distinct if _parallel(slopes[:, :, i], slopes[:, :, k])), None
            )
            if equivalent is None:
                distinct.append(i)
            else:
                self._note_same(augmented.unknown_inputs[equivalent], augmented.unknown_inputs[i])
        return tuple(augmented.unknown_inputs[i] for i in distinct)

    def _note_same(self, a: UnknownInput, b: UnknownInput) -> None:
        text = (
            f"in this model a missing {a.balance} term and a missing {b.balance} term do the same: "
        )
        text += f"what is entered under {a.balance} [{a.unit}] may be either"
        if text not in self.notes:
            self.notes.append(text)
            self.same[a.balance] = (*self.same.get(a.balance, ()), b.balance)


def _parallel(a: Array, b: Array) -> bool:
    """Whether two unknown inputs push everything in the same direction at every instant: rows (N, n + S)."""
    felt = (np.linalg.norm(a, axis=1) > 0) | (np.linalg.norm(b, axis=1) > 0)
    dot = np.abs(np.einsum("ki,ki->k", a, b))[felt]
    norms = (np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1))[felt]
    return bool((dot >= (1 - _PARALLEL_TERMS) * norms).all() and (norms > 0).all())
