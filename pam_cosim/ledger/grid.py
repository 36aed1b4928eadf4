"""Where in time the model is held against the samples: nodes, steps and the inputs on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.compiler import Ode
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation.inputs import Pieces, pieces
from pam_cosim.starts import start_time

STAGE = 1 / 3  # where Radau IIA of order 3 looks inside a step
_LEAST_STEPS = 200  # a run with few samples is stepped through finer than these
_INSIDE = 1e-9  # part of a step by which its end is approached: an input may jump there


@dataclass(frozen=True)
class Grid:
    """All runs, one after another: N nodes, M steps from a node to the next.

    Attributes:
        runs: the runs.
        first: (R + 1,) position of each run's first node, and N.
        time: (N,) [s].
        start_node: (M,) node that a step starts from; it ends at the next.
        step: (M,) [s].
        parameters: (R, P) all parameters of the model [SI], in its order.
        node_inputs, stage_inputs: (N, U) and (M, U) [SI]; at a node as the step that ends there has them.
        node_delayed, stage_delayed: (N, D) and (M, D), the delayed inputs.
        measured: (N, S) samples by signal [SI], NaN where there is none.
        starts: (R, n) states at the start of each run [SI], NaN where it is that of the model.
    """

    runs: tuple[Run, ...]
    first: NDArray[np.intp]
    time: Array
    start_node: NDArray[np.intp]
    step: Array
    parameters: Array
    node_inputs: Array
    stage_inputs: Array
    node_delayed: Array
    stage_delayed: Array
    measured: Array
    starts: Array

    @property
    def run_of_node(self) -> NDArray[np.intp]:
        """(N,) position of the run."""
        return np.repeat(np.arange(len(self.runs)), np.diff(self.first))

    def nodes(self, run: int) -> slice:
        """The nodes of a run."""
        return slice(int(self.first[run]), int(self.first[run + 1]))


def make_grid(
    ode: Ode,
    data: DataSet,
    runs: Sequence[Run],
    values: Mapping[str, float],
    signals: Sequence[str],
    spacing: float,
    extra_nodes: Sequence[Array] = (),
) -> Grid:
    """Nodes at the samples and jumps of the inputs of some runs.

    Args:
        ode: the model.
        data: the data set of the runs.
        runs: R runs.
        values: parameters and start values by name [SI].
        signals: S names; their samples become ``measured``.
        spacing: smallest distance of nodes, except at jumps of an input [s].
        extra_nodes: (k,) further times for each run [s].
    """
    defaults = {n: v.start or 0.0 for n, v in ode.interface.parameters.items()}
    times, inputs, stages, delayed, stage_delayed, measured, parameters, starts = (
        [],
        [],
        [],
        [],
        [],
        [],
        [],
        [],
    )
    for r, run in enumerate(runs):
        stated = data.parameters_of(run, values)
        p = np.array([stated.get(n, v) for n, v in defaults.items()])
        inputs_of_run = _input_pieces(ode, run, stated)
        sample_times = _shown(ode, run, p)
        t = _node_times(run, sample_times, inputs_of_run, spacing)
        if extra_nodes:
            t = np.union1d(t, extra_nodes[r])
        end = np.append(t[:1], t[1:] - _INSIDE * np.diff(t))
        inside = t[:-1] + STAGE * np.diff(t)
        times.append(t)
        inputs.append(_at(inputs_of_run, end))
        stages.append(_at(inputs_of_run, inside))
        delayed.append(_delayed(ode, p, inputs_of_run, end, t[0]))
        stage_delayed.append(_delayed(ode, p, inputs_of_run, inside, t[0]))
        measured.append(_samples(run, sample_times, t, signals))
        parameters.append(p)
        starts.append([stated.get(state.name, np.nan) for state in ode.states])
    first_nodes = np.cumsum([0, *(len(t) for t in times)])
    ends = first_nodes[1:] - 1
    interval_starts = np.setdiff1d(np.arange(first_nodes[-1]), ends)
    time = np.concatenate(times)
    return Grid(
        tuple(runs),
        first_nodes,
        time,
        interval_starts,
        time[interval_starts + 1] - time[interval_starts],
        np.array(parameters),
        np.concatenate(inputs),
        np.concatenate(stages),
        np.concatenate(delayed),
        np.concatenate(stage_delayed),
        np.concatenate(measured),
        np.array(starts).reshape(len(runs), len(ode.states)),
    )


def _input_pieces(ode: Ode, run: Run, stated: Mapping[str, float]) -> list[Pieces]:
    """Of each input: as recorded, as stated for the whole run, or the model's default."""
    inputs_of_run = []
    for name, variable in ode.interface.inputs.items():
        values = run.inputs.get(name)
        if values is None:
            values = np.full(len(run.time), stated.get(name, variable.start or 0.0))
        inputs_of_run.append(pieces(run.time, np.asarray(values, float), run.interpolation))
    return inputs_of_run


def _shown(ode: Ode, run: Run, p: Array) -> Array:
    """(n,) when the instruments showed what a run has recorded [s], by the clock of the inputs."""
    clocks = ode.interface.record_delays
    late = sum(
        float(value)
        for name, value in zip(ode.interface.parameters, p, strict=True)
        if name in clocks
    )
    return np.maximum(run.time - late, start_time(run)) if late else run.time


def _node_times(run: Run, shown: Array, inputs_of_run: Sequence[Pieces], spacing: float) -> Array:
    sampled = np.unique(shown)
    begin, end = start_time(run), float(sampled[-1])
    spacing = min(spacing, (end - begin) / _LEAST_STEPS)
    bends = np.unique(np.concatenate([np.zeros(0), *(c.time[1:] for c in inputs_of_run)]))
    bends = bends[(bends > begin) & (bends < end)]
    if len(bends) > len(sampled) / 4:  # a measured input bends at every sample
        bends = bends[:0]
    fixed = np.union1d(bends, [begin, end])
    node_parts = [fixed[:1]]
    for a, b in zip(fixed[:-1].tolist(), fixed[1:].tolist(), strict=True):
        sample_times = sampled[(sampled > a) & (sampled < b)]
        slots = np.floor((sample_times - a) / spacing * (1 + 1e-9))
        chosen = sample_times[np.diff(slots, prepend=0.0) > 0]
        ends = np.append(chosen, b)
        starts = np.append(a, chosen)
        for start, stop in zip(starts.tolist(), ends.tolist(), strict=True):
            parts = max(1, int(np.ceil((stop - start) / spacing / 2)))
            node_parts.append(np.linspace(start, stop, parts + 1)[1:])
    return np.concatenate(node_parts)


def _at(inputs_of_run: Sequence[Pieces], times: Array) -> Array:
    return np.column_stack([np.zeros((len(times), 0)), *(c.at(times)[0] for c in inputs_of_run)])


def _delayed(
    ode: Ode, p: Array, inputs_of_run: Sequence[Pieces], times: Array, start: float
) -> Array:
    columns = [np.zeros((len(times), 0))]
    if ode.delays:
        late = np.array(
            ca.Function("late", [ode.p], [ca.vertcat(*[d.time for d in ode.delays])])(p)
        ).ravel()
        for delay, by in zip(ode.delays, late.tolist(), strict=True):
            before = times - by
            if delay.input is None:
                columns.append((before >= start).astype(float))
            else:
                columns.append(inputs_of_run[delay.input].at(np.maximum(before, start))[0])
    return np.column_stack(columns)


def _samples(run: Run, sample_times: Array, times: Array, signals: Sequence[str]) -> Array:
    samples = np.full((len(times), len(signals)), np.nan)
    for j, name in enumerate(signals):
        values = run.measurements.get(name)
        if values is None:
            continue
        is_measured = np.isfinite(values)
        at, last = np.unique(sample_times[is_measured][::-1], return_index=True)
        last_values = values[is_measured][::-1][last]
        place = np.searchsorted(times, at)
        place = np.minimum(place, len(times) - 1)
        is_at_node = np.abs(times[place] - at) <= 1e-9 * np.maximum(1.0, np.abs(at))
        samples[place[is_at_node], j] = last_values[is_at_node]
    return samples
