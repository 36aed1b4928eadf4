"""The result of a sweep: one labelled data set, run by run or as tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Trajectory
from pam_cosim.sweeps.design import Design
from pam_cosim.sweeps.patterns import INPUTS
from pam_cosim.sweeps.records import Records
from pam_cosim.sweeps.scalars import Scalar
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, distinct_warnings, look_first

if TYPE_CHECKING:
    import pandas
    import xarray


_FEW = 8  # runs that a notebook shows


@dataclass(frozen=True)
class SweepPoint(Printed):
    """One run of a sweep.

    Attributes:
        parameters: what was varied [SI].
        trajectory: its values over time; None where the run failed or they were not kept.
        scalars: numbers of the run, by name [unit of each]; NaN where it failed.
        failure: why it failed; None: it did not.
    """

    parameters: dict[str, float]
    trajectory: Trajectory | None
    scalars: dict[str, float]
    failure: str | None = None

    def __str__(self) -> str:
        values = {**self.parameters, **self.scalars}
        lines = [", ".join(f"{name} = {value:.6g}" for name, value in values.items())]
        return "\n".join([*lines, *filter(None, [self.failure])])


class Sweep(Printed):
    """Runs in the order of the design; a sequence of ``SweepPoint``.

    Attributes:
        interface: of the model.
        design: which runs.
        fixed: further values of all runs [SI].
        time: (n,) [s].
        outputs: variables that were kept over time.
        scalars: numbers that were made of each run.
    """

    def __init__(
        self,
        interface: Interface,
        design: Design,
        fixed: Mapping[str, float],
        time: Array,
        outputs: tuple[str, ...],
        scalars: tuple[Scalar, ...],
        table: Records,
    ) -> None:
        self.interface, self.design, self.fixed, self.time = interface, design, dict(fixed), time
        self.outputs, self.scalars, self.table = outputs, scalars, table
        self.partial: Path | None = None  # the file that keeps the runs until they are saved

    def __len__(self) -> int:
        return len(self.design)

    @overload
    def __getitem__(self, run: int) -> SweepPoint: ...
    @overload
    def __getitem__(self, run: slice) -> list[SweepPoint]: ...
    def __getitem__(self, run: int | slice) -> SweepPoint | list[SweepPoint]:
        if isinstance(run, slice):
            return [self[i] for i in range(*run.indices(len(self)))]
        if not -len(self) <= run < len(self):
            raise IndexError(f"there are {len(self)} runs")
        run %= len(self)
        failure = self.table.failure(run) or None
        numbers = self.table.scalars()[run].tolist()
        scalars = dict(zip((s.name for s in self.scalars), numbers, strict=True))
        return SweepPoint(
            self.design.settings(run), None if failure else self._trajectory(run), scalars, failure
        )

    def __iter__(self) -> Iterator[SweepPoint]:
        return (self[i] for i in range(len(self)))

    def _trajectory(self, run: int) -> Trajectory | None:
        if not self.outputs:
            return None
        values = dict(zip(self.outputs, self.table.values(run), strict=True))
        return Trajectory(self.time, values, {name: self.units[name] for name in self.outputs})

    @property
    def units(self) -> dict[str, str]:
        """Of outputs, of what was varied and of scalars, by name."""
        variables = self.interface.variables
        return {
            **self.design.units,
            **{name: variables[name].unit for name in self.outputs},
            **{s.name: s.unit for s in self.scalars},
        }

    @property
    def failed(self) -> dict[int, str]:
        """Why runs failed, by their numbers, from 0."""
        return {i: text for i, text in enumerate(self.table.failures()) if text}

    @property
    def warnings(self) -> tuple[str, ...]:
        """The distinct warnings of the model, each with its runs by their numbers, from 0."""
        return distinct_warnings(
            {f"run {i}": texts for i, texts in enumerate(self.table.warnings())}
        )

    def column(self, scalar: str) -> Array:
        """(runs,) one number of every run [its unit]."""
        return self.table.scalars()[:, [s.name for s in self.scalars].index(scalar)]

    def to_xarray(self) -> xarray.Dataset:
        """All of it, labelled and with units: what was varied are the axes of a grid, or coordinates along "run"."""
        from pam_cosim.sweeps.labelled import dataset

        return dataset(self)

    def to_frame(self) -> pandas.DataFrame:
        """A row for each run: what was varied, scalars, and why a run failed; ``attrs["units"]`` has the units."""
        from pam_cosim.sweeps.labelled import frame

        return frame(self)

    def save(self, path: Path | str) -> Path:
        """Writes NetCDF (.nc), Parquet (.parquet) or CSV (.csv, or no ending), whole or not at all.

        NetCDF holds everything. A table holds a row for each run where there are scalars, and otherwise a row for each
        time of each run.

        Raises:
            InputError: the name ends otherwise, or the file cannot be written.
        """
        from pam_cosim.sweeps.saving import save

        save(self, Path(path))
        if self.partial is not None:
            self.partial.unlink(missing_ok=True)
            self.partial = None
        return Path(path)

    def __str__(self) -> str:
        names = [f"{name} {self._span(i)}" for i, name in enumerate(self.design.names)]
        varied = ", ".join(names)
        lines = [f"{len(self)} runs of {self.interface.model} ({self.design.kind}): {varied}"]
        lines += look_first(self.warnings)
        lines += [f"  {line}" for line in self.summary_lines()]
        if self.failed:
            lines.append(
                f"  {len(self.failed)} runs failed; the first: {next(iter(self.failed.values()))}"
            )
        return "\n".join(lines)

    def summary_lines(self) -> list[str]:
        """A line for each scalar: between which values it lies."""
        lines = []
        for scalar in self.scalars:
            values = self.column(scalar.name)
            good = values[np.isfinite(values)]
            if good.size:
                low, high = (
                    format_quantity(float(v), scalar.unit) for v in (good.min(), good.max())
                )
                lines.append(f"{scalar.name}: from {low} to {high}")
            if unknown := len(self) - len(self.failed) - good.size:
                runs = "1 run has" if unknown == 1 else f"{unknown} runs have"
                lines.append(
                    f"{scalar.name}: {runs} not settled, so that the whole change is not known; make them longer"
                )
        return lines

    def _span(self, i: int) -> str:
        values, unit = self.design.points[:, i], list(self.design.units.values())[i]
        if self.design.patterns and self.design.names[i] == INPUTS:
            return f"of {len(self.design.patterns)} patterns"
        low, high = (
            format_quantity(float(values.min()), unit),
            format_quantity(float(values.max()), unit),
        )
        return low if low == high else f"from {low} to {high}"

    def _repr_html_(self) -> str:
        head = self.to_frame().head(_FEW)
        return f"{super()._repr_html_()}{head.to_html(escape=True)}"

    def summary(self) -> dict[str, Any]:
        """Plain data: model, settings, number of runs and of failures."""
        return {
            "model": self.interface.model,
            "settings": self.fixed,
            "design": self.design.kind,
            "runs": len(self),
            "failed": len(self.failed),
        }
