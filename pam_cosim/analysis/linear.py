"""The product of a linearisation: a model of state, input and output matrices that knows its names and units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from pam_cosim.analysis.operating_point import OperatingPoint
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.exports import Exported, Table
from pam_cosim.libraries import library
from pam_cosim.units import is_dimensionless, quotient
from pam_cosim.wording import Printed, did_you_mean

# A pole closer to zero than this part of the largest is an integrator: rounding alone parts it from zero.
_INTEGRATOR = 1e-12
# What JSON has of the point; the units are those of the model.


@dataclass(frozen=True)
class Mode:
    """One pole, or a pair of complex ones.

    Attributes:
        pole: [1/s]; of a pair the one above the real axis.
        time_constant: [s], 1/|Re|: negative where the mode grows, infinite where it neither grows nor decays.
        frequency: [Hz], natural; |pole|/(2 pi).
        damping: ratio, -Re/|pole|; not a number for an integrator.
        shares: how much each state takes part (participation factors), by name, adding up to 1.
    """

    pole: complex
    time_constant: float
    frequency: float
    damping: float
    shares: dict[str, float]


@dataclass(frozen=True)
class LinearModel(Printed, Exported):
    """d(dx)/dt = A dx + B du, dy = C dx + D du about an operating point; all in the units of the model (SI).

    Attributes:
        model: its name.
        A, B, C, D: (n, n), (n, m), (p, n), (p, m).
        states, inputs, outputs: names, in the order of the matrices.
        units: of each of them.
        point: where it holds; deviations dx, du, dy count from there.
        method: how the derivatives were found.
        notes: what to know of it, in sentences.
    """

    json_keys = (
        "model states inputs outputs units A B C D method notes point stable=is_stable modes "
        "static_gain"
    )

    model: str
    A: Array
    B: Array
    C: Array
    D: Array
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    units: dict[str, str]
    point: OperatingPoint
    method: str
    notes: tuple[str, ...] = ()

    @property
    def poles(self) -> Array:
        """(n,) complex [1/s], the slowest first."""
        values = np.linalg.eigvals(self.A) if self.states else np.zeros(0)
        return np.asarray(values[np.lexsort((-values.imag, np.abs(values)))])

    @property
    def is_stable(self) -> bool:
        """Whether every deviation decays; what an integrator holds does not."""
        sizes = np.abs(self.poles)
        return bool(np.all((self.poles.real < 0) & ~_is_integrator(sizes)))

    @property
    def modes(self) -> list[Mode]:
        """Time constants, natural frequencies and damping, the slowest first; a complex pair is one mode."""
        if not self.states:
            return []
        values, right_vectors = np.linalg.eig(self.A)
        left_vectors = np.linalg.pinv(right_vectors)
        order = np.lexsort((-values.imag, np.abs(values)))
        still = _is_integrator(np.abs(values))
        return [
            self._mode(values[i], right_vectors[:, i] * left_vectors[i], bool(still[i]))
            for i in order
            if values[i].imag >= 0
        ]

    def _mode(self, pole: complex, taking_part: Array, still: bool) -> Mode:
        size, real = abs(pole), pole.real
        share = np.abs(taking_part) / max(float(np.abs(taking_part).sum()), np.finfo(float).tiny)
        return Mode(
            complex(pole),
            float("inf") if still or real == 0.0 else -1.0 / float(real),
            float(size / (2 * np.pi)),
            float("nan") if still else float(-real / size),
            dict(zip(self.states, share.tolist(), strict=True)),
        )

    @property
    def static_gain(self) -> Array:
        """(p, m) outputs per input in the long run, D - C A^-1 B; not a number where the model integrates or grows."""
        if not self.states:
            return self.D.copy()
        if not self.is_stable or not np.isfinite(np.linalg.cond(self.A)):
            return np.full(self.D.shape, np.nan)
        return np.asarray(self.D - self.C @ np.linalg.solve(self.A, self.B))

    def response(self, frequencies: Sequence[float] | Array) -> Array:
        """(k, p, m) complex gain from inputs to outputs at frequencies (k,) [Hz]."""
        s = 2j * np.pi * np.asarray(frequencies, dtype=float)
        if not self.states:
            return np.broadcast_to(self.D.astype(complex), (len(s), *self.D.shape)).copy()
        unit = np.eye(len(self.states))
        return np.array(
            [self.C @ np.linalg.solve(value * unit - self.A, self.B) + self.D for value in s]
        )

    def step(self, times: Sequence[float] | Array) -> Array:
        """(k, p, m) outputs at times (k,) [s] after each input alone stepped by one of its units; exact."""
        n, m = self.B.shape
        augmented = np.block([[self.A, self.B], [np.zeros((m, n + m))]])
        responses = [expm(augmented * t)[:n, n:] for t in np.asarray(times, dtype=float)]
        return np.array([self.C @ step_response + self.D for step_response in responses])

    def select(
        self,
        inputs: Sequence[str] | None = None,
        outputs: Sequence[str] | None = None,
        states: Sequence[str] | None = None,
    ) -> LinearModel:
        """A smaller model with these inputs and outputs, in this order.

        Where ``states`` are named, the others follow them at once: their rates are set to zero, which keeps the static
        gain and the slow modes (singular perturbation).

        Raises:
            InputError: an unknown name; states that cannot follow, because they integrate.
        """
        chosen_u = self._places(inputs, self.inputs, "input")
        chosen_y = self._places(outputs, self.outputs, "output")
        small = (
            self if states is None else self._reduced(self._places(states, self.states, "state"))
        )
        return replace(
            small,
            B=small.B[:, chosen_u],
            C=small.C[chosen_y],
            D=small.D[np.ix_(chosen_y, chosen_u)],
            inputs=tuple(self.inputs[i] for i in chosen_u),
            outputs=tuple(self.outputs[i] for i in chosen_y),
        )

    def _places(
        self, names: Sequence[str] | None, available: Sequence[str], role: str
    ) -> list[int]:
        if names is None:
            return list(range(len(available)))
        for name in names:
            if name not in available:
                raise InputError(
                    f"this linear model has no {role} '{name}'; {did_you_mean(name, available)}"
                )
        return [list(available).index(name) for name in names]

    def _reduced(self, slow: list[int]) -> LinearModel:
        fast = [i for i in range(len(self.states)) if i not in slow]
        if not fast:
            return replace(
                self,
                A=self.A[np.ix_(slow, slow)],
                B=self.B[slow],
                C=self.C[:, slow],
                states=tuple(self.states[i] for i in slow),
            )
        fast_block = self.A[np.ix_(fast, fast)]
        if np.linalg.matrix_rank(fast_block) < len(fast):
            raise InputError(
                f"{', '.join(self.states[i] for i in fast)}: cannot be quasi-static; keep one more state"
            )
        on_x, on_u = (
            np.linalg.solve(fast_block, self.A[np.ix_(fast, slow)]),
            np.linalg.solve(fast_block, self.B[fast]),
        )
        across, seen = self.A[np.ix_(slow, fast)], self.C[:, fast]
        return replace(
            self,
            A=self.A[np.ix_(slow, slow)] - across @ on_x,
            B=self.B[slow] - across @ on_u,
            C=self.C[:, slow] - seen @ on_x,
            D=self.D - seen @ on_u,
            states=tuple(self.states[i] for i in slow),
            notes=(
                *self.notes,
                f"{', '.join(self.states[i] for i in fast)}: taken as quasi-static.",
            ),
        )

    def to_scipy(self) -> Any:
        """A ``scipy.signal.StateSpace``.

        Raises:
            InputError: without states; SciPy's is of one at least.
        """
        if not self.states:
            raise InputError(f"{self.model} has no states and only a matrix D")
        from scipy.signal import StateSpace  # a fifth of a second, which few need

        return StateSpace(self.A, self.B, self.C, self.D)

    def to_control(self) -> Any:
        """A ``control.StateSpace`` of python-control, with the names of states, inputs and outputs.

        Raises:
            InputError: python-control is not installed.
        """
        # its names must not contain a dot
        plain = [
            [name.replace(".", "_") for name in names]
            for names in (self.states, self.inputs, self.outputs)
        ]
        return library("control").ss(
            self.A,
            self.B,
            self.C,
            self.D,
            states=plain[0],
            inputs=plain[1],
            outputs=plain[2],
            name=self.model.rpartition(".")[2],
            remove_useless_states=False,
        )

    def table(self) -> Table:
        """[A B; C D]: a row for each rate and output, a column for each state and input."""
        heads = ["", *(self._headed(name) for name in (*self.states, *self.inputs))]
        return heads, [
            [head, *row] for head, row in zip(self._rows(), self._table().tolist(), strict=True)
        ]

    def _table(self) -> Array:
        return np.asarray(np.block([[self.A, self.B], [self.C, self.D]]))

    def _rows(self) -> list[str]:
        rates = [f"der({name}) [{quotient(self.units.get(name, ''), 's')}]" for name in self.states]
        return [*rates, *(self._headed(name) for name in self.outputs)]

    def _headed(self, name: str) -> str:
        unit = self.units.get(name, "")
        return f"{name} [{unit}]" if unit else name

    def __str__(self) -> str:
        heads = [self._headed(name) for name in (*self.states, *self.inputs)]
        cells = [[f"{v:.6g}" for v in row] for row in self._table().tolist()]
        rows = self._rows()
        width = max(map(len, rows), default=0)
        widths = [max(map(len, column)) for column in zip(heads, *cells, strict=True)]
        lines = [f"{self.model} {self.point}", ""]
        lines.append(
            " " * width + "".join(f"  {head:>{w}}" for head, w in zip(heads, widths, strict=True))
        )
        for title, row in zip(rows, cells, strict=True):
            lines.append(
                f"{title:<{width}}"
                + "".join(f"  {cell:>{w}}" for cell, w in zip(row, widths, strict=True))
            )
        lines += ["", *self.modes_text(), *self.gain_text(), f"by {self.method}", *self.notes]
        return "\n".join(lines).rstrip()

    def modes_text(self) -> list[str]:
        """One line for each mode."""
        return [f"mode {i}: {_mode_text(mode)}" for i, mode in enumerate(self.modes, 1)]

    def gain_text(self) -> list[str]:
        """One line for each output with its static gains; empty where there are none."""
        gain = self.static_gain
        if not gain.size or not np.isfinite(gain).all():
            return []
        lines = []
        for i, output in enumerate(self.outputs):
            parts = []
            for j, name in enumerate(self.inputs):
                unit = quotient(self.units.get(output, ""), self.units.get(name, ""))
                words = (
                    f"{gain[i, j] + 0.0:.6g}",
                    "" if is_dimensionless(unit) else unit,
                    f"by {name}",
                )
                parts.append(" ".join(filter(None, words)))
            lines.append(f"static gain of {output}: {', '.join(parts)}")
        return lines


def _is_integrator(sizes: Array) -> NDArray[np.bool_]:
    """(n,) whether each pole of these magnitudes is negligible compared with the largest."""
    return np.asarray(sizes <= _INTEGRATOR * sizes.max(initial=0.0))


def _mode_text(mode: Mode) -> str:
    names = ", ".join(f"{name} {share:.0%}" for name, share in mode.shares.items() if share >= 0.1)
    if not np.isfinite(mode.time_constant):
        what = (
            "integrates"
            if np.isnan(mode.damping)
            else f"swings undamped at {mode.frequency:.4g} Hz"
        )
    elif mode.pole.imag:
        what = f"{mode.frequency:.4g} Hz, damping ratio {mode.damping:.4g}"
    elif mode.time_constant > 0:
        what = f"time constant {mode.time_constant:.4g} s"
    else:
        what = f"grows with time constant {-mode.time_constant:.4g} s"
    return f"{what} ({names})"
