"""Keeps the ledger of a model on a data set.

The free parameters of the data set are estimated anew beside every missing term: what one of their values explains
is not missing. What is compared are explanations of the same samples by their marginal likelihood, so that a term that
may be any function of time does not win by being able to:

- the model by itself, and with a fault of one instrument that is the same in all runs (``sensor``);
- the model with a hole in each balance at once, each a random walk whose roughness the samples choose;
- where neither reaches the noise, or a balance fails that may stand for one without a hole (``Domain.confused``): the
  same with a law replaced by one that leaves a hole, as the library offers it;
- where none reaches the noise: the holes together with a fault of one instrument, whose samples are then left out.

What cannot be told apart is found, not assumed: two holes that push every state and every signal in the same
direction at all times are one hole, and the ledger says so. Not told apart, and not noticed: two missing terms of one
balance; a term and what a free parameter can imitate of it (``Course.imitated``); a fault that changes from run to run
and physics; two instruments at fault; a fault of an instrument beside a wrong law that only it shows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.catalogue import domain_of
from pam_cosim.compiler import ClassTree, read_library
from pam_cosim.criteria import CRITERIA
from pam_cosim.domain import Domain
from pam_cosim.errors import InputError
from pam_cosim.ledger.books import TERM, Books, Hole, open_books
from pam_cosim.ledger.grid import Grid, make_grid
from pam_cosim.ledger.ledger import Course, Entry, Ledger, Reading
from pam_cosim.ledger.march import further_nodes, march
from pam_cosim.ledger.model import Model
from pam_cosim.ledger.sensor import Alone, SensorFault, fault_beside, try_sensors
from pam_cosim.ledger.smoother import Point, Problem, Smoothed, hole_sizes, smooth, with_some
from pam_cosim.measurement import DataSet


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
        data: the measurement; every signal needs a noise level (``pam_cosim.fitting.complete_noise``).
        values: parameters [SI], as a fit of the model found them; those under [fit] are estimated along from there.
        model: full name of a class, a bench's name, or a ``.mo`` file.
        effects: names of effects that the model has.
        files: the user's Modelica files.
        tree: the library with these files, if it was read already.

    Raises:
        InputError: a signal without a noise level; an FMU, which has no balances to open; an unknown effect.
        ModelError: the model cannot be compiled.
    """
    name = model or data.model
    if name.endswith(".fmu"):
        raise InputError("a ledger can be kept of a Modelica model only: an FMU has no balances to open", name)
    sources = [*files, Path(name)] if name.endswith(".mo") else list(files)
    tree = tree or read_library(files=sources)
    every = open_books(tree, name, effects, files=sources)
    return _Keeping(data, dict(values or {}), every, domain_of(tree, name)).ledger()


@dataclass(frozen=True)
class _Opened:
    """Smoothed books: problem, holes that act, and the estimate; the fault of an instrument that is not believed."""

    books: Books
    problem: Problem
    holes: tuple[Hole, ...]
    free: tuple[str, ...]
    found: Smoothed
    fault: SensorFault | None = None

    @property
    def deviance(self) -> float:
        """Of all samples, those of an instrument that is not believed with its fault."""
        return self.found.deviance + (self.fault.deviance if self.fault else 0.0)

    @property
    def chi2(self) -> float:
        """As ``deviance``."""
        return self.found.chi2 + (self.fault.chi2 if self.fault else 0.0)

    def alone(self, hole: Hole) -> tuple[float, float]:
        return with_some(self.problem, self.found, [self.holes.index(hole)])

    def without(self, hole: Hole) -> tuple[float, float]:
        return with_some(self.problem, self.found, [i for i, h in enumerate(self.holes) if h is not hole])


class _Keeping:
    """One ledger in the making."""

    def __init__(self, data: DataSet, values: Mapping[str, float], every: Sequence[Books], domain: Domain) -> None:
        self.data, self.values, self.every, self.domain = data, values, every, domain
        interface = every[0].ode.interface
        if not every[0].ode.states:
            raise InputError(f"{data.model} has no states: there is no balance to keep a ledger of", data.model)
        self.signals = [n for n, s in data.signals.items() if s.fitted and n in interface.outputs]
        unknown = [n for n in self.signals if not data.signals[n].sigma]
        if unknown:
            raise InputError(f"the noise of {', '.join(unknown)} is not known: a ledger weighs signals by their noise")
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
        books = self.every[0]
        problem, states = self._problem(books, ())
        alone = try_sensors(problem, states, [(n, self.data.signals[n].unit) for n in self.signals])
        opened = self._open(books, states)
        samples = int(np.isfinite(problem.grid.measured).sum())
        best = min([alone.chi2, *(f.chi2 for f in alone.faults), *([opened.found.chi2] if opened else [])]) / samples
        replaced = None
        by_itself = min([alone.deviance, *(f.deviance for f in alone.faults)])
        if best > CRITERIA.ledger.at_noise or (opened and opened.found.deviance < by_itself and self._swallows(opened)):
            for further in self.every[1:]:
                candidate = self._open(further)
                if candidate and (replaced is None or candidate.found.deviance < replaced.found.deviance):
                    replaced = candidate
        plain = replaced is not None and replaced.deviance < CRITERIA.ledger.at_noise * samples
        beside = self._beside() if best > CRITERIA.ledger.at_noise and not plain else None
        return self._judged(alone, opened, replaced, beside, samples)

    def _beside(self) -> _Opened | None:
        """The holes together with a fault of one instrument, the most probable one."""
        found: list[_Opened] = []
        for j, name in enumerate(self.signals):
            if len(self.signals) < 2:
                break
            opened = self._open(self.every[0], None, name)
            if opened is None:
                continue
            grid, free = opened.problem.grid, opened.found.point.free.tolist()
            measured = self._problem(self.every[0], ())[0].grid.measured[:, j]
            signal = (name, self.data.signals[name].unit)
            course = opened.found.linear.outputs[:, j]
            fault = fault_beside(grid, signal, measured, course, float(self.sigma[j]), free)
            fault = replace(fault, deviance=fault.deviance + 2 * float(np.log(len(self.signals))))
            found.append(replace(opened, fault=fault))
        return min(found, key=lambda o: o.deviance, default=None)

    def _swallows(self, opened: _Opened) -> bool:
        """Whether a term is at work next to a balance that the model has no hole in, so that it may stand for it."""
        covered = {h.balance for h in opened.holes}
        neighbours = [h for b in self.every[1:] for h in b.holes if h.balance not in covered]
        if not neighbours:
            return False
        hiding = {row[0] for row in self.domain.confused}
        working = [h for h in opened.holes if h.balance in hiding]
        return any(opened.without(h)[0] > opened.found.deviance + CRITERIA.evidence.very_strong for h in working)

    # ---- explanations -----------------------------------------------------------------------------------------

    def _problem(
        self, books: Books, holes: Sequence[Hole], hidden: str | None = None, states: tuple[Array, Array] | None = None
    ) -> tuple[Problem, tuple[Array, Array]]:
        longest = max(float(r.time[-1] - r.time[0]) for r in self.data.runs)
        spacing = (
            min(CRITERIA.ledger.spacing, longest / CRITERIA.ledger.fewest_nodes)
            if longest < CRITERIA.ledger.spacing * CRITERIA.ledger.most_nodes
            else longest / CRITERIA.ledger.most_nodes
        )
        grid = self._grid(books, spacing)
        if hidden is not None:
            measured = grid.measured.copy()
            measured[:, self.signals.index(hidden)] = np.nan
            grid = replace(grid, measured=measured)
        model = Model(books.ode, [h.parameter for h in holes], self.free, self.signals)
        prior_deviation = (self.high - self.low) / CRITERIA.ledger.free_prior
        none = Problem(
            model, grid, self.sigma, self.start, prior_deviation, self.low, self.high,
            np.ones(model.states), np.ones(len(holes)),
        )  # fmt: skip
        states = states or march(model, grid, none.parameters(self.start))
        ranges = np.ptp(states[0], axis=0)
        size = np.where(ranges > 0, ranges, np.maximum(np.max(np.abs(states[0]), axis=0), 1e-6))
        p = none.parameters(self.start)
        hole_size = hole_sizes(model, grid, states[0], self.start, p, self.sigma.tolist())
        return replace(none, size=size, hole_size=hole_size), states

    def _grid(self, books: Books, spacing: float) -> Grid:
        """The grid of some books, fine enough for the model by itself: finer ones would not change what it says."""
        key = self.every.index(books)
        if key not in self.grids:
            args = (books.ode, self.data, self.data.runs, self.values, self.signals, spacing)
            grid, model = make_grid(*args), Model(books.ode, [], self.free, self.signals)
            p = grid.parameters.copy()
            p[:, model.free_at] = self.start
            states = march(model, grid, p)
            further = [np.zeros(0) for _ in grid.runs]
            for _ in range(CRITERIA.ledger.refinements):
                new = further_nodes(model, grid, p, states, CRITERIA.ledger.accuracy)
                further = [np.union1d(a, b) for a, b in zip(further, new, strict=True)]
                finer = make_grid(*args, further)
                states_of_finer = march(model, finer, p)
                if self._same_outputs(model, (grid, states[0]), (finer, states_of_finer[0]), p):
                    break
                grid, states = finer, states_of_finer
            self.grids[key] = grid
        return self.grids[key]

    def _same_outputs(self, model: Model, coarse: tuple[Grid, Array], fine: tuple[Grid, Array], p: Array) -> bool:
        """Whether the signals agree where both grids have nodes, far below the noise."""
        found = []
        for grid, x in (coarse, fine):
            run = grid.run_of_node
            slopes = model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p[run])
            found.append((run, grid.time, slopes.value[:, model.states :]))
        (run, time, few), (run_of_fine, time_of_fine, many) = found
        common = np.zeros(len(time_of_fine), dtype=bool)
        for r in range(len(coarse[0].runs)):
            common[run_of_fine == r] = np.isin(time_of_fine[run_of_fine == r], time[run == r])
        difference = (few - many[common]) / self.sigma
        return bool(np.sqrt(np.mean(difference**2)) < CRITERIA.ledger.far_below)

    def _open(
        self, books: Books, states: tuple[Array, Array] | None = None, hidden: str | None = None
    ) -> _Opened | None:
        """The model with all holes that act and can be told apart; None where there is none, or it breaks down."""
        problem, states = self._problem(books, books.holes, hidden, states)
        kept = self._distinct(books, problem, states[0])
        if not kept:
            return None
        problem, _ = self._problem(books, kept, hidden, states)
        start = Point(*states, np.zeros((len(states[0]), len(kept))), self.start)
        try:
            return _Opened(books, problem, kept, tuple(self.free), smooth(problem, start))
        except (np.linalg.LinAlgError, ValueError):
            self.notes.append("the balances could not be opened: the model breaks down near the measured course")
            return None

    def _distinct(self, books: Books, problem: Problem, x: Array) -> tuple[Hole, ...]:
        if not books.holes:
            return ()
        grid, kept = problem.grid, list[int]()
        p = grid.parameters[grid.run_of_node]
        slopes = problem.model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p).by_hole
        slopes = slopes / np.maximum(np.max(np.abs(slopes), axis=(0, 2), keepdims=True), 1e-300)
        order = sorted(range(len(books.holes)), key=lambda i: (self.domain.place(books.holes[i].balance), i))
        for i in order:
            if not problem.hole_size[i] > 0:
                continue
            same = next((k for k in kept if _parallel(slopes[:, :, i], slopes[:, :, k])), None)
            if same is None:
                kept.append(i)
            else:
                self._note_same(books.holes[same], books.holes[i])
        return tuple(books.holes[i] for i in kept)

    def _note_same(self, a: Hole, b: Hole) -> None:
        text = f"in this model a missing {a.balance} term and a missing {b.balance} term do the same: "
        text += f"what is entered under {a.balance} [{a.unit}] may be either"
        if text not in self.notes:
            self.notes.append(text)
            self.same[a.balance] = (*self.same.get(a.balance, ()), b.balance)

    # ---- judgement --------------------------------------------------------------------------------------------

    def _judged(
        self, alone: Alone, opened: _Opened | None, replaced: _Opened | None, beside: _Opened | None, samples: int
    ) -> Ledger:
        excess = max(alone.chi2 - samples, 1e-9)

        def explained(chi2: float) -> float:
            return float(np.clip((alone.chi2 - max(chi2, samples)) / excess, 0.0, 1.0))

        fault = alone.faults[0] if alone.faults else None
        deviances = {
            "none": alone.deviance,
            "sensor": (fault.deviance if fault else np.inf) + 2 * np.log(max(len(alone.faults), 1)),
            "opened": opened.found.deviance if opened else np.inf,
            "replaced": replaced.deviance if replaced else np.inf,
            "beside": beside.deviance if beside else np.inf,
        }
        best = min(deviances, key=lambda k: deviances[k])
        if deviances[best] > alone.deviance - CRITERIA.evidence.very_strong:
            best = "none"
        rival = {"opened": "replaced", "replaced": "opened"}.get(best, "none")
        if best != "none" and rival != "none" and deviances[rival] < deviances[best] + CRITERIA.evidence.very_strong:
            assert replaced is not None
            self.notes.append(self._confusion(self._replaced_balance(replaced)))
        winner = {"opened": opened, "replaced": replaced, "beside": beside}.get(best)
        losses = self._losses(best, winner, fault, deviances)
        total = sum(losses.values())
        failing = tuple(
            sorted((b for b, v in losses.items() if v > CRITERIA.evidence.very_strong), key=lambda b: -losses[b])
        )
        after = {
            "none": alone.chi2, "sensor": fault.chi2 if fault else np.inf,
        }.get(best, winner.chi2 if winner else np.inf) / samples  # fmt: skip
        shown = winner or opened
        if best == "sensor" and fault is not None:
            shown = self._open(self.every[0], None, fault.signal) or opened
        disbelieved = fault if best == "sensor" else winner.fault if winner else None
        if disbelieved is not None:
            text = f"the reading of {disbelieved.signal} is not believed: the other balances were kept without it"
            self.notes.append(text)
        entries = self._entries(alone, opened, replaced, shown, losses, total, explained)
        readings = [_reading(f, alone.deviance - f.deviance, explained(f.chi2)) for f in alone.faults]
        if winner and winner.fault:
            own = _reading(winner.fault, alone.deviance - winner.deviance, explained(winner.chi2))
            readings = [own, *(r for r in readings if r.signal != own.signal)]
        free = fault.free if best == "sensor" and fault else tuple(winner.found.point.free if winner else self.start)
        return Ledger(
            model=self.every[0].ode.interface.model if not self.data.model else self.data.model,
            entries=tuple(sorted(entries, key=lambda e: (-e.share, -e.explains, e.balance))),
            readings=tuple(readings),
            failing=failing,
            closed=bool(after <= CRITERIA.ledger.at_noise),
            before=alone.chi2 / samples,
            after=float(after),
            parameters=dict(zip(self.free, map(float, free), strict=True)),
            notes=tuple(self.notes),
            domain=self.domain,
        )

    def _confusion(self, balance: str) -> str:
        """What to say where the model with a law replaced, which has a hole in ``balance``, explains as much."""
        told = next((words for _, hidden, words in self.domain.confused if hidden == balance), None)
        return told or f"a law that leaves a hole in the balance of {balance} explains the samples as well"

    def _losses(
        self, best: str, winner: _Opened | None, fault: SensorFault | None, deviances: Mapping[str, float]
    ) -> dict[str, float]:
        """What the best explanation loses without each of its balances."""
        if best == "sensor" and fault is not None:
            return {"sensor": min(v for k, v in deviances.items() if k != "sensor") - deviances["sensor"]}
        if winner is None:
            return {}
        losses = {h.balance: max(winner.without(h)[0] - winner.found.deviance, 0.0) for h in winner.holes}
        if winner.fault is not None:
            others = min(v for k, v in deviances.items() if k != best)
            losses["sensor"] = max(others - deviances[best], 0.0)
        if winner.books.replaced:  # the law that was replaced counts too
            own = winner.holes[-1].balance if len(winner.holes) == 1 else self._replaced_balance(winner)
            losses[own] = max(losses.get(own, 0.0), min(v for k, v in deviances.items() if k != best) - deviances[best])
        return losses

    def _replaced_balance(self, winner: _Opened) -> str:
        before = {h.parameter for h in self.every[0].holes}
        return next(h.balance for h in winner.books.holes if h.parameter not in before)

    def _entries(
        self,
        alone: Alone,
        opened: _Opened | None,
        replaced: _Opened | None,
        shown: _Opened | None,
        losses: Mapping[str, float],
        total: float,
        explained: object,
    ) -> list[Entry]:
        assert callable(explained)
        found: dict[str, Entry] = {}
        for books in (opened, replaced):
            for hole in books.holes if books else ():
                if hole.balance in found and books is not replaced:
                    continue
                assert books is not None
                worth, chi2 = books.alone(hole)
                share = losses.get(hole.balance, 0.0) / total if total else 0.0
                entry = Entry(
                    hole.balance,
                    float(alone.deviance - worth),
                    explained(chi2),
                    share,
                    hole.unit,
                    hole.meaning,
                    hole.parameter,
                )
                if hole.balance not in found or entry.gain > found[hole.balance].gain:
                    found[hole.balance] = entry
        for hole in shown.holes if shown else ():
            assert shown is not None
            old = found.get(hole.balance) or Entry(hole.balance, 0.0, 0.0, 0.0)
            courses, units = _courses(shown, hole)
            found[hole.balance] = replace(
                old,
                unit=hole.unit,
                meaning=hole.meaning,
                term=hole.parameter,
                courses=courses,
                units=units,
                base=hole.base,
                same_as=() if shown.books.replaced else self.same.get(hole.balance, ()),
            )
        if alone.faults:
            fault = alone.faults[0]
            share = losses.get("sensor", 0.0) / total if total else 0.0
            found["sensor"] = Entry(
                "sensor", alone.deviance - fault.deviance, explained(fault.chi2), share,
                note="an instrument that is off by a constant or a factor, or lags, the same in all runs",
            )  # fmt: skip
        return list(found.values())


def _parallel(a: Array, b: Array) -> bool:
    """Whether two holes push everything in the same direction at every instant: rows (N, n + S)."""
    felt = (np.linalg.norm(a, axis=1) > 0) | (np.linalg.norm(b, axis=1) > 0)
    dot = np.abs(np.einsum("ki,ki->k", a, b))[felt]
    norms = (np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1))[felt]
    return bool((dot >= (1 - CRITERIA.ledger.parallel) * norms).all() and (norms > 0).all())


def _courses(opened: _Opened, hole: Hole) -> tuple[tuple[Course, ...], dict[str, str]]:
    problem, found, j = opened.problem, opened.found, opened.holes.index(hole)
    grid: Grid = problem.grid
    p = problem.parameters(found.point.free)[grid.run_of_node]
    p[:, problem.model.hole_at] = found.point.w
    names = _variables(opened.books, hole)
    every = problem.model.variables(grid.time, found.point.x, grid.node_inputs, grid.node_delayed, p)
    against = {short: every[full] for short, full in names.items() if np.ptp(every[full]) > 0}
    against = {n: against[n] for n in sorted(against, key=lambda n: n not in hole.variables)}
    against.pop(TERM, None)
    value = found.point.w[:, j]
    against = {n: v for n, v in against.items() if not np.allclose(v, value, rtol=1e-6, atol=0)}
    units = {n: opened.books.ode.interface.locals[names[n]].unit for n in against}
    imitated = _imitated(opened, p, j)
    courses = []
    for r, run in enumerate(grid.runs):
        at = grid.nodes(r)
        own = {n: v[at] for n, v in against.items()}
        same = {n: imitated[at, q] for q, n in enumerate(opened.free)}
        courses.append(Course(run.name, run.role, grid.time[at], value[at], found.deviation[at, j], own, same))
    return tuple(courses), units


def _imitated(opened: _Opened, parameters: Array, j: int) -> Array:
    """(N, Q) [unit of the term per unit of the parameter]: how much of term ``j`` acts as each free parameter does.

    Rates only are asked, weighed by the size of their states: what a parameter does to a signal at once, no term does.
    """
    grid, model = opened.problem.grid, opened.problem.model
    point = opened.found.point
    slopes = model.everything(grid.time, point.x, grid.node_inputs, grid.node_delayed, parameters)
    n = model.states
    weight = 1 / opened.problem.size
    hole = slopes.by_hole[:, :n, j] * weight
    free = slopes.by_parameter[:, :n] * weight[:, None]
    if not np.any(hole):  # the term acts on a signal alone
        hole, free = (
            slopes.by_hole[:, n:, j] / opened.problem.sigma,
            slopes.by_parameter[:, n:] / opened.problem.sigma[:, None],
        )
    found: Array = np.einsum("ki,kiq->kq", hole, free) / np.maximum(np.sum(hole**2, axis=1), 1e-300)[:, None]
    return found


def _variables(books: Books, hole: Hole) -> dict[str, str]:
    """Variables of the component that holds a term: short and full names."""
    prefix = hole.parameter.rpartition(".")[0] + "."
    names = [n for n in books.ode.interface.locals if n.startswith(prefix) and "." not in n[len(prefix) :]]
    return {n[len(prefix) :]: n for n in names}


def _reading(fault: SensorFault, evidence: float, explains: float) -> Reading:
    return Reading(
        fault.signal, fault.unit, fault.offset, fault.offset_deviation, fault.gain, fault.gain_deviation, fault.lag,
        evidence, explains,
    )  # fmt: skip
