"""Estimates the ledger of a model on a data set.

The free parameters of the data set are estimated anew beside every missing term: what one of their values explains
is not missing. What is compared are explanations of the same samples by their marginal likelihood, so that a term that
may be any function of time does not win by being able to:

- the model by itself, and with a fault of one instrument that is the same in all runs (``sensor``);
- the augmented model: an unknown input in each balance at once, each a random walk whose noise intensity the samples
  choose;
- where neither reaches the noise, or a balance fails that may stand for one without an unknown input
  (``Domain.confused``): the same with a law replaced by one that has an unknown input, as the library offers it;
- where none reaches the noise: the unknown inputs together with a fault of one instrument, whose samples are then left
  out.

What cannot be told apart is found, not assumed: two unknown inputs that push every state and every signal in the same
direction at all times are one, and the ledger says so. Not told apart, and not noticed: two missing terms of one
balance; a term and what a free parameter can imitate of it (``Course.imitated``); a fault that changes from run to run
and physics; two instruments at fault; a fault of an instrument beside a wrong law that only it shows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.catalogue import domain_of
from pam_cosim.compiler import ClassTree, read_library
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.ledger.augmented import TERM, AugmentedModel, UnknownInput, augmented_models
from pam_cosim.ledger.explanation import Explanation, Rivals
from pam_cosim.ledger.grid import Grid, make_grid
from pam_cosim.ledger.ledger import BalanceEntry, Ledger, SensorReading, TermSeries
from pam_cosim.ledger.model import Model
from pam_cosim.ledger.radau import further_nodes, integrate
from pam_cosim.ledger.sensor import SensorFault, Unaugmented, fault_beside, try_sensors
from pam_cosim.ledger.smoother import Point, SmoothingProblem, smooth, unknown_sizes
from pam_cosim.measurement import DataSet
from pam_cosim.model.domain import Domain
from pam_cosim.model.references import is_fmu, sources_of


def keep_ledger(
    data: DataSet,
    values: Mapping[str, float] | None = None,
    model: str | None = None,
    *,
    effects: Sequence[str] = (),
    files: Sequence[Path] = (),
    tree: ClassTree | None = None,
) -> Ledger:
    """The ledger of ``model`` (default: the bench of the data set) with ``effects`` on all runs.

    Args:
        data: the measurement.
        values: parameters [SI], as a fit of the model found them; those under [fit] are estimated along from there.
        model: full name of a class, a bench's name, or a ``.mo`` file.
        effects: names of effects that the model has.
        files: the user's Modelica files.
        tree: the library with these files, if it was read already.

    Raises:
        InputError: an FMU, which has no balances to open; an unknown effect; points at rest, while balances are kept
            over time.
        ModelError: the model cannot be compiled.
    """
    name = data.model_for(model)
    if any(run.is_static for run in data.runs):
        raise InputError("a ledger is kept over time, and points at rest have none", data.folder)
    if is_fmu(name):
        raise InputError("a ledger can be kept of a Modelica model only: an FMU has no balances to open", name)
    sources = sources_of(files, name)
    tree = tree or read_library(files=sources)
    models = augmented_models(tree, name, effects, files=sources)
    return _Estimation(data, dict(values or {}), models, domain_of(tree, name)).ledger()


class _Estimation:
    """One ledger in the making."""

    def __init__(
        self, data: DataSet, values: Mapping[str, float], models: Sequence[AugmentedModel], domain: Domain
    ) -> None:
        self.data, self.values, self.models, self.domain = data, values, models, domain
        interface = models[0].ode.interface
        if not models[0].ode.states:
            raise InputError(f"{data.model} has no states: there is no balance to keep a ledger of", data.model)
        self.signals = [n for n, s in data.signals.items() if s.fitted and n in interface.outputs]
        self.sigma = np.array([data.signals[n].sigma for n in self.signals], dtype=float)
        self.free = [n for n in data.fit if n in interface.parameters]
        self.low = np.array([data.fit[n].min for n in self.free])
        self.high = np.array([data.fit[n].max for n in self.free])
        starts = data.parameters_of(data.runs[0], values)
        defaults = {n: v.start or 0.0 for n, v in interface.parameters.items()}
        self.start = np.clip([float({**defaults, **starts}[n]) for n in self.free], self.low, self.high)
        self.notes: list[str] = []
        self.grids: dict[int, Grid] = {}
        self.same: dict[str, tuple[str, ...]] = {}

    def ledger(self) -> Ledger:
        """All explanations, the best of them, and the entries that it leaves."""
        first = self.models[0]
        problem, states = self._problem(first, ())
        unaugmented = try_sensors(problem, states, [(n, self.data.signals[n].unit) for n in self.signals])
        augmented = self._explain(first, states)
        samples = int(np.isfinite(problem.grid.measured).sum())
        smoothed = [augmented.smoothed.chi2] if augmented else []
        best = min([unaugmented.chi2, *(f.chi2 for f in unaugmented.faults), *smoothed]) / samples
        is_open = best > CRITERIA.ledger.at_noise
        replaced = self._replaced() if is_open or self._is_doubtful(unaugmented, augmented) else None
        plain = replaced is not None and replaced.deviance < CRITERIA.ledger.at_noise * samples
        beside = self._beside() if is_open and not plain else None
        return self._judged(Rivals(unaugmented, augmented, replaced, beside, samples))

    def _is_doubtful(self, unaugmented: Unaugmented, augmented: Explanation | None) -> bool:
        """Whether unknown inputs explain the samples, and one of them may do so for what has none."""
        by_itself = min([unaugmented.deviance, *(f.deviance for f in unaugmented.faults)])
        return augmented is not None and augmented.smoothed.deviance < by_itself and self._swallows(augmented)

    def _replaced(self) -> Explanation | None:
        """The best one with a law replaced by an unknown input."""
        found = [one for one in map(self._explain, self.models[1:]) if one is not None]
        return min(found, key=lambda one: one.smoothed.deviance, default=None)

    def _beside(self) -> Explanation | None:
        """The unknown inputs together with a fault of one instrument, the most probable one."""
        explanations: list[Explanation] = []
        for j, name in enumerate(self.signals):
            if len(self.signals) < 2:
                break
            explanation = self._explain(self.models[0], None, name)
            if explanation is None:
                continue
            grid, free = explanation.problem.grid, explanation.smoothed.point.free.tolist()
            measured = self._problem(self.models[0], ())[0].grid.measured[:, j]
            signal = (name, self.data.signals[name].unit)
            course = explanation.smoothed.linear.outputs[:, j]
            fault = fault_beside(grid, signal, measured, course, float(self.sigma[j]), free)
            fault = replace(fault, deviance=fault.deviance + 2 * float(np.log(len(self.signals))))
            explanations.append(replace(explanation, fault=fault))
        return min(explanations, key=lambda o: o.deviance, default=None)

    def _swallows(self, explanation: Explanation) -> bool:
        """Whether a term is at work next to a balance without an unknown input, so that it may stand for it."""
        covered = {u.balance for u in explanation.unknown_inputs}
        neighbours = [u for b in self.models[1:] for u in b.unknown_inputs if u.balance not in covered]
        if not neighbours:
            return False
        hiding = {row[0] for row in self.domain.confused}
        working = [u for u in explanation.unknown_inputs if u.balance in hiding]
        return any(
            explanation.without(u)[0] > explanation.smoothed.deviance + CRITERIA.evidence.very_strong for u in working
        )

    # ---- explanations -----------------------------------------------------------------------------------------

    def _problem(
        self,
        augmented: AugmentedModel,
        unknown_inputs: Sequence[UnknownInput],
        hidden: str | None = None,
        states: tuple[Array, Array] | None = None,
    ) -> tuple[SmoothingProblem, tuple[Array, Array]]:
        longest = max(float(r.time[-1] - r.time[0]) for r in self.data.runs)
        spacing = (
            min(CRITERIA.ledger.spacing, longest / CRITERIA.ledger.fewest_nodes)
            if longest < CRITERIA.ledger.spacing * CRITERIA.ledger.most_nodes
            else longest / CRITERIA.ledger.most_nodes
        )
        grid = self._grid(augmented, spacing)
        if hidden is not None:
            measured = grid.measured.copy()
            measured[:, self.signals.index(hidden)] = np.nan
            grid = replace(grid, measured=measured)
        model = Model(augmented.ode, [u.parameter for u in unknown_inputs], self.free, self.signals)
        prior_deviation = (self.high - self.low) / CRITERIA.ledger.free_prior
        none = SmoothingProblem(
            model,
            grid,
            self.sigma,
            self.start,
            prior_deviation,
            self.low,
            self.high,
            np.ones(model.states),
            np.ones(len(unknown_inputs)),
        )
        states = states or integrate(model, grid, none.parameters(self.start))
        ranges = np.ptp(states[0], axis=0)
        size = np.where(ranges > 0, ranges, np.maximum(np.max(np.abs(states[0]), axis=0), 1e-6))
        p = none.parameters(self.start)
        unknown_size = unknown_sizes(model, grid, states[0], self.start, p, self.sigma.tolist())
        return replace(none, size=size, unknown_size=unknown_size), states

    def _grid(self, augmented: AugmentedModel, spacing: float) -> Grid:
        """The grid of an augmented model, fine enough for the model by itself: a finer one changes nothing."""
        key = self.models.index(augmented)
        if key not in self.grids:
            args = (augmented.ode, self.data, self.data.runs, self.values, self.signals, spacing)
            grid, model = make_grid(*args), Model(augmented.ode, [], self.free, self.signals)
            p = grid.parameters.copy()
            p[:, model.free_at] = self.start
            states = integrate(model, grid, p)
            further = [np.zeros(0) for _ in grid.runs]
            for _ in range(CRITERIA.ledger.refinements):
                new = further_nodes(model, grid, p, states, CRITERIA.ledger.accuracy)
                further = [np.union1d(a, b) for a, b in zip(further, new, strict=True)]
                finer = make_grid(*args, further)
                states_of_finer = integrate(model, finer, p)
                if self._same_outputs(model, (grid, states[0]), (finer, states_of_finer[0]), p):
                    break
                grid, states = finer, states_of_finer
            self.grids[key] = grid
        return self.grids[key]

    def _same_outputs(self, model: Model, coarse: tuple[Grid, Array], fine: tuple[Grid, Array], p: Array) -> bool:
        """Whether the signals agree where both grids have nodes, far below the noise."""
        outputs = []
        for grid, x in (coarse, fine):
            run = grid.run_of_node
            slopes = model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p[run])
            outputs.append((run, grid.time, slopes.value[:, model.states :]))
        (run, time, few), (run_of_fine, time_of_fine, many) = outputs
        common = np.zeros(len(time_of_fine), dtype=bool)
        for r in range(len(coarse[0].runs)):
            common[run_of_fine == r] = np.isin(time_of_fine[run_of_fine == r], time[run == r])
        difference = (few - many[common]) / self.sigma
        return bool(np.sqrt(np.mean(difference**2)) < CRITERIA.ledger.far_below)

    def _explain(
        self, augmented: AugmentedModel, states: tuple[Array, Array] | None = None, hidden: str | None = None
    ) -> Explanation | None:
        """The model with all unknown inputs that act and can be told apart; None without any, or if it breaks down."""
        problem, states = self._problem(augmented, augmented.unknown_inputs, hidden, states)
        kept = self._distinct(augmented, problem, states[0])
        if not kept:
            return None
        problem, _ = self._problem(augmented, kept, hidden, states)
        start = Point(*states, np.zeros((len(states[0]), len(kept))), self.start)
        try:
            return Explanation(augmented, problem, kept, tuple(self.free), smooth(problem, start))
        except (np.linalg.LinAlgError, ValueError):
            self.notes.append("the balances could not be opened: the model breaks down near the measured course")
            return None

    def _distinct(self, augmented: AugmentedModel, problem: SmoothingProblem, x: Array) -> tuple[UnknownInput, ...]:
        if not augmented.unknown_inputs:
            return ()
        grid, kept = problem.grid, list[int]()
        p = grid.parameters[grid.run_of_node]
        slopes = problem.model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p).by_unknown_input
        slopes = slopes / np.maximum(np.max(np.abs(slopes), axis=(0, 2), keepdims=True), 1e-300)
        order = sorted(
            range(len(augmented.unknown_inputs)),
            key=lambda i: (self.domain.place(augmented.unknown_inputs[i].balance), i),
        )
        for i in order:
            if not problem.unknown_size[i] > 0:
                continue
            same = next((k for k in kept if _parallel(slopes[:, :, i], slopes[:, :, k])), None)
            if same is None:
                kept.append(i)
            else:
                self._note_same(augmented.unknown_inputs[same], augmented.unknown_inputs[i])
        return tuple(augmented.unknown_inputs[i] for i in kept)

    def _note_same(self, a: UnknownInput, b: UnknownInput) -> None:
        text = f"in this model a missing {a.balance} term and a missing {b.balance} term do the same: "
        text += f"what is entered under {a.balance} [{a.unit}] may be either"
        if text not in self.notes:
            self.notes.append(text)
            self.same[a.balance] = (*self.same.get(a.balance, ()), b.balance)

    # ---- judgement --------------------------------------------------------------------------------------------

    def _judged(self, rivals: Rivals) -> Ledger:
        """The ledger that the best explanation leaves."""
        unaugmented, winner = rivals.unaugmented, rivals.winner
        if rivals.is_confused:
            assert rivals.replaced is not None
            self.notes.append(self._confusion(self._replaced_balance(rivals.replaced)))
        losses = self._losses(rivals)
        failing = [balance for balance, loss in losses.items() if loss > CRITERIA.evidence.very_strong]
        entries = self._entries(rivals, losses)
        if rivals.believed_fault is not None:
            signal = rivals.believed_fault.signal
            self.notes.append(f"the reading of {signal} is not believed: the other balances were kept without it")
        free = tuple(winner.smoothed.point.free if winner else self.start)
        if rivals.best == "sensor" and rivals.fault:
            free = rivals.fault.free
        after = rivals.chi2 / rivals.samples
        return Ledger(
            model=self.data.model or self.models[0].ode.interface.model,
            entries=tuple(sorted(entries, key=lambda e: (-e.share, -e.explains, e.balance))),
            readings=tuple(_readings(rivals)),
            failing=tuple(sorted(failing, key=lambda balance: -losses[balance])),
            closed=bool(after <= CRITERIA.ledger.at_noise),
            before=unaugmented.chi2 / rivals.samples,
            after=float(after),
            parameters=dict(zip(self.free, map(float, free), strict=True)),
            notes=tuple(self.notes),
            domain=self.domain,
        )

    def _confusion(self, balance: str) -> str:
        """What to say where a law replaced by an unknown input in ``balance`` explains as much."""
        told = next((words for _, hidden, words in self.domain.confused if hidden == balance), None)
        return told or f"a law that leaves the balance of {balance} open explains the samples as well"

    def _losses(self, rivals: Rivals) -> dict[str, float]:
        """What the best explanation loses without each of its balances."""
        best, winner, deviances = rivals.best, rivals.winner, rivals.deviances
        second = min(deviance for name, deviance in deviances.items() if name != best)
        if best == "sensor" and rivals.fault is not None:
            return {"sensor": second - deviances[best]}
        if winner is None:
            return {}
        losses = {u.balance: max(winner.without(u)[0] - winner.smoothed.deviance, 0.0) for u in winner.unknown_inputs}
        if winner.fault is not None:
            losses["sensor"] = max(second - deviances[best], 0.0)
        if winner.augmented.replaced:  # the law that was replaced counts too
            alone = len(winner.unknown_inputs) == 1
            own = winner.unknown_inputs[-1].balance if alone else self._replaced_balance(winner)
            losses[own] = max(losses.get(own, 0.0), second - deviances[best])
        return losses

    def _replaced_balance(self, winner: Explanation) -> str:
        before = {u.parameter for u in self.models[0].unknown_inputs}
        return next(u.balance for u in winner.augmented.unknown_inputs if u.parameter not in before)

    def _entries(self, rivals: Rivals, losses: Mapping[str, float]) -> list[BalanceEntry]:
        """An entry for each balance: what it explains, its part of the loss, and its course in time."""
        total = sum(losses.values())
        shares = {balance: loss / total for balance, loss in losses.items()} if total else {}
        entries = _weighed(rivals, shares)
        shown = rivals.winner or rivals.augmented
        if rivals.best == "sensor" and rivals.fault is not None:
            shown = self._explain(self.models[0], None, rivals.fault.signal) or rivals.augmented
        if shown is not None:
            for unknown_input in shown.unknown_inputs:
                old = entries.get(unknown_input.balance) or BalanceEntry(unknown_input.balance, 0.0, 0.0, 0.0)
                entries[unknown_input.balance] = self._with_course(old, shown, unknown_input)
        if rivals.fault is not None:
            entries["sensor"] = BalanceEntry(
                "sensor",
                rivals.unaugmented.deviance - rivals.fault.deviance,
                rivals.explained(rivals.fault.chi2),
                shares.get("sensor", 0.0),
                note="an instrument that is off by a constant or a factor, or lags, the same in all runs",
            )
        return list(entries.values())

    def _with_course(self, entry: BalanceEntry, shown: Explanation, unknown_input: UnknownInput) -> BalanceEntry:
        courses, units = _courses(shown, unknown_input)
        return replace(
            entry,
            unit=unknown_input.unit,
            meaning=unknown_input.meaning,
            term=unknown_input.parameter,
            courses=courses,
            units=units,
            base=unknown_input.base,
            same_as=() if shown.augmented.replaced else self.same.get(unknown_input.balance, ()),
        )


def _readings(rivals: Rivals) -> list[SensorReading]:
    """What a fault of each instrument explains, that of the best explanation first."""
    before, winner = rivals.unaugmented.deviance, rivals.winner
    readings = [_reading(f, before - f.deviance, rivals.explained(f.chi2)) for f in rivals.unaugmented.faults]
    if winner is None or winner.fault is None:
        return readings
    own = _reading(winner.fault, before - winner.deviance, rivals.explained(winner.chi2))
    return [own, *(r for r in readings if r.signal != own.signal)]


def _weighed(rivals: Rivals, shares: Mapping[str, float]) -> dict[str, BalanceEntry]:
    """What an unknown input in each balance explains by itself; in the place of a law, where it explains more."""
    entries: dict[str, BalanceEntry] = {}
    for explanation in filter(None, (rivals.augmented, rivals.replaced)):
        for unknown_input in explanation.unknown_inputs:
            balance = unknown_input.balance
            if balance in entries and explanation is not rivals.replaced:
                continue
            deviance, chi2 = explanation.with_only(unknown_input)
            entry = BalanceEntry(
                balance,
                float(rivals.unaugmented.deviance - deviance),
                rivals.explained(chi2),
                shares.get(balance, 0.0),
                unknown_input.unit,
                unknown_input.meaning,
                unknown_input.parameter,
            )
            if balance not in entries or entry.gain > entries[balance].gain:
                entries[balance] = entry
    return entries


def _parallel(a: Array, b: Array) -> bool:
    """Whether two unknown inputs push everything in the same direction at every instant: rows (N, n + S)."""
    felt = (np.linalg.norm(a, axis=1) > 0) | (np.linalg.norm(b, axis=1) > 0)
    dot = np.abs(np.einsum("ki,ki->k", a, b))[felt]
    norms = (np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1))[felt]
    return bool((dot >= (1 - CRITERIA.ledger.parallel) * norms).all() and (norms > 0).all())


def _courses(explanation: Explanation, unknown_input: UnknownInput) -> tuple[tuple[TermSeries, ...], dict[str, str]]:
    problem, smoothed, j = explanation.problem, explanation.smoothed, explanation.unknown_inputs.index(unknown_input)
    grid: Grid = problem.grid
    p = problem.parameters(smoothed.point.free)[grid.run_of_node]
    p[:, problem.model.unknown_at] = smoothed.point.w
    names = _variables(explanation.augmented, unknown_input)
    variables = problem.model.variables(grid.time, smoothed.point.x, grid.node_inputs, grid.node_delayed, p)
    against = {short: variables[full] for short, full in names.items() if np.ptp(variables[full]) > 0}
    against = {n: against[n] for n in sorted(against, key=lambda n: n not in unknown_input.variables)}
    against.pop(TERM, None)
    value = smoothed.point.w[:, j]
    against = {n: v for n, v in against.items() if not np.allclose(v, value, rtol=1e-6, atol=0)}
    units = {n: explanation.augmented.ode.interface.locals[names[n]].unit for n in against}
    imitated = _imitated(explanation, p, j)
    courses = []
    for r, run in enumerate(grid.runs):
        at = grid.nodes(r)
        own = {n: v[at] for n, v in against.items()}
        same = {n: imitated[at, q] for q, n in enumerate(explanation.free)}
        courses.append(TermSeries(run.name, run.role, grid.time[at], value[at], smoothed.deviation[at, j], own, same))
    return tuple(courses), units


def _imitated(explanation: Explanation, parameters: Array, j: int) -> Array:
    """(N, Q) [unit of the term per unit of the parameter]: how much of term ``j`` acts as each free parameter does.

    Rates only are asked, weighed by the size of their states: what a parameter does to a signal at once, no term does.
    """
    grid, model = explanation.problem.grid, explanation.problem.model
    point = explanation.smoothed.point
    slopes = model.everything(grid.time, point.x, grid.node_inputs, grid.node_delayed, parameters)
    n = model.states
    weight = 1 / explanation.problem.size
    unknown_input = slopes.by_unknown_input[:, :n, j] * weight
    free = slopes.by_parameter[:, :n] * weight[:, None]
    if not np.any(unknown_input):  # the term acts on a signal alone
        unknown_input, free = (
            slopes.by_unknown_input[:, n:, j] / explanation.problem.sigma,
            slopes.by_parameter[:, n:] / explanation.problem.sigma[:, None],
        )
    imitated: Array = (
        np.einsum("ki,kiq->kq", unknown_input, free) / np.maximum(np.sum(unknown_input**2, axis=1), 1e-300)[:, None]
    )
    return imitated


def _variables(augmented: AugmentedModel, unknown_input: UnknownInput) -> dict[str, str]:
    """Variables of the component that holds a term: short and full names."""
    prefix = unknown_input.parameter.rpartition(".")[0] + "."
    names = [n for n in augmented.ode.interface.locals if n.startswith(prefix) and "." not in n[len(prefix) :]]
    return {n[len(prefix) :]: n for n in names}


def _reading(fault: SensorFault, evidence: float, explains: float) -> SensorReading:
    return SensorReading(
        fault.signal,
        fault.unit,
        fault.offset,
        fault.offset_deviation,
        fault.gain,
        fault.gain_deviation,
        fault.lag,
        evidence,
        explains,
    )
