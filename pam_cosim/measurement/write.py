"""Writes a data set: ``experiment.toml`` and one CSV file a run, in the units the caller chooses."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.files import check_writable, make_folder, write_text
from pam_cosim.measurement.data_set import FILE_NAME, DataSet, Run
from pam_cosim.measurement.free_parameter import FreeParameter
from pam_cosim.measurement.read import read_data_set
from pam_cosim.measurement.start import Start
from pam_cosim.measurement.table import TIME
from pam_cosim.model.interface import Interface
from pam_cosim.toml_text import toml_key, toml_string
from pam_cosim.units import UnitError, convert, is_dimensionless


def write_data_set(
    folder: Path,
    data_set: DataSet,
    interface: Interface,
    *,
    units: Mapping[str, str] | None = None,
    digits: int = 9,
) -> DataSet:
    """Writes ``data_set`` to ``folder`` and returns it as it reads from there.

    Nothing is written unless everything can be read back. A run's CSV file is called after the run; other files of
    the folder stay as they are. Samples of a lead are written where the rows of its time still are those that they were
    read from; otherwise their cells are empty, and the lead, which is not scored, begins without them.

    Args:
        folder: made when it is missing.
        data_set: numbers in the bench's units; its ``folder`` and the runs' ``file`` do not matter.
        interface: the bench.
        units: unit in the files by name of a signal, an input, a parameter or "time"; the bench's unit otherwise.
        digits: significant digits in the CSV files.

    Raises:
        InputError: the data set is one that ``read_data_set`` refuses, or the folder cannot be written.
    """
    writer = _Writer(data_set, interface, dict(units or {}), digits)
    texts = {_file_name(run): writer.table(run) for run in data_set.runs}
    texts[FILE_NAME] = writer.experiment()  # Last: a folder without it is no data set.
    folder = Path(folder)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent, prefix=f".{folder.name}-") as name:
            draft = Path(name)
            _write_texts(draft, texts)
            read_data_set(draft, lambda _: interface)
        for file in texts:
            check_writable(folder / file, new_folder=True)
        for file, text in texts.items():
            make_folder((folder / file).parent)
            write_text(folder / file, text)
    except OSError as error:
        raise InputError(f"the data set cannot be written: {error.strerror}", folder) from None
    return read_data_set(folder, lambda _: interface)


def _file_name(run: Run) -> str:
    return f"{run.name}.csv"


def _with_lead(run: Run) -> dict[str, NDArray[np.float64]]:
    """The measurements with the samples of the lead, where these are still of the run's own rows."""
    measurements = dict(run.measurements)
    early = run.time < run.time[0] + run.start.lead
    for name, (time, values) in run.start.leading.items():
        if name in measurements and np.array_equal(time, run.time[early]):
            extended = measurements[name].copy()
            extended[early] = values
            measurements[name] = extended
    return measurements


def _write_texts(folder: Path, texts: Mapping[str, str]) -> None:
    for name, text in texts.items():
        file = folder / name
        if not file.resolve().is_relative_to(folder.resolve()):
            raise InputError(f"the run file '{name}' would leave the folder", folder)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8", newline="\n")


class _Writer:
    """Renders a data set as texts of files, with the caller's units."""

    def __init__(
        self, data_set: DataSet, interface: Interface, units: dict[str, str], digits: int
    ) -> None:
        self.data_set, self.units, self.digits = data_set, units, digits
        variables = {**interface.parameters, **interface.outputs, **interface.inputs}
        self.si = {TIME: "s", **{name: variable.unit for name, variable in variables.items()}}

    def table(self, run: Run) -> str:
        time = {} if run.is_static else {TIME: run.time}
        columns = {**time, **run.inputs, **_with_lead(run)}
        values = [self._converted(name, column) for name, column in columns.items()]
        header = ",".join(self._heading(name) for name in columns)
        rows = (
            ",".join("" if np.isnan(value) else f"{value:.{self.digits}g}" for value in row)
            for row in np.column_stack(values)
        )
        return "\n".join([header, *rows, ""])

    def experiment(self) -> str:
        return "\n".join(
            [*self._head(), *self._parameters(), *self._free(), *self._effects(), *self._runs(), ""]
        )

    def _head(self) -> Iterator[str]:
        yield f"title = {toml_string(self.data_set.title)}"
        yield f"model = {toml_string(self.data_set.model)}"
        for name, signal in self.data_set.signals.items():
            if not signal.fitted:
                continue
            yield f"\n[signals.{toml_key(name)}]"
            stated = signal.as_stated()
            if stated.sigma is not None:
                yield f"sigma = {self._quantity(name, stated.sigma, difference=True)}"
            if stated.sigma_of_reading:
                yield f"sigma_of_reading = {stated.sigma_of_reading!r}"
            if stated.repeatability:
                yield f"repeatability = {self._quantity(name, stated.repeatability, difference=True)}"

    def _parameters(self) -> Iterator[str]:
        if self.data_set.parameters:
            yield "\n[parameters]"
        yield from self._values(self.data_set.parameters)

    def _free(self) -> Iterator[str]:
        shared = [free for free in self.data_set.fit.values() if not free.run]
        if shared:
            yield "\n[fit]"
        yield from map(self._free_table, shared)

    def _free_table(self, free: FreeParameter) -> str:
        name = free.parameter
        bounds = {"min": free.min, "max": free.max, "start": free.start}
        cells = [
            f"{key} = {self._quantity(name, bound)}"
            for key, bound in bounds.items()
            if bound is not None
        ]
        if free.transform is not None:
            cells.append(f'transform = "{free.transform}"')
        if free.prior is not None:
            mean, sd = (
                self._quantity(name, free.prior.mean),
                self._quantity(name, free.prior.sd, difference=True),
            )
            cells.append(f"prior = {{ mean = {mean}, sd = {sd} }}")
        return f"{toml_string(name)} = {{ {', '.join(cells)} }}"

    def _effects(self) -> Iterator[str]:
        lists = {"exclude": self.data_set.excluded, "expect": self.data_set.expected}
        if any(lists.values()):
            yield "\n[effects]"
        yield from (
            f"{key} = [{', '.join(map(toml_string, names))}]"
            for key, names in lists.items()
            if names
        )

    def _runs(self) -> Iterator[str]:
        shared = self.data_set.parameters
        for run in self.data_set.runs:
            yield f'\n[[runs]]\nfile = {toml_string(_file_name(run))}\nrole = "{run.role}"'
            if run.is_static:
                yield 'kind = "static"'
            yield from self._start(run.start)
            is_told = run.interpolation_stated or run.interpolation != "linear"
            if is_told and not run.is_static:
                yield f'interpolation = "{run.interpolation}"'
            differing = {
                name: value for name, value in run.parameters.items() if shared.get(name) != value
            }
            if differing:
                yield "[runs.parameters]"
            yield from self._values(differing)
            free = [
                parameter for parameter in self.data_set.fit.values() if parameter.run == run.name
            ]
            if free:
                yield "[runs.fit]"
            yield from map(self._free_table, free)

    def _start(self, start: Start) -> Iterator[str]:
        if start.mode is not None and not start.chosen:
            yield f'start = "{start.mode}"'
        if start.seconds:
            held = ", ".join([*self._values(start.before), f"for = {self._seconds(start.seconds)}"])
            yield f"before = {{ {held} }}"
        if start.lead:
            yield f"lead = {self._seconds(start.lead)}"
        if start.periodic:
            yield "periodic = true"

    def _seconds(self, seconds: float) -> str:
        return self._quantity(TIME, seconds)

    def _values(self, values: Mapping[str, float]) -> Iterator[str]:
        return (
            f"{toml_string(name)} = {self._quantity(name, value)}" for name, value in values.items()
        )

    def _unit(self, name: str) -> str:
        return self.units.get(name, self._si_unit(name))

    def _si_unit(self, name: str) -> str:
        if name not in self.si:
            raise InputError(f"the bench has no input, output or parameter '{name}'")
        return self.si[name]

    def _heading(self, name: str) -> str:
        unit = self._unit(name)
        return name if is_dimensionless(unit) else f"{name} [{unit}]"

    def _quantity(self, name: str, value: float, *, difference: bool = False) -> str:
        number = f"{float(self._converted(name, value, difference=difference)):.12g}"
        unit = self._unit(name)
        return number if is_dimensionless(unit) else toml_string(f"{number} {unit}")

    def _converted(
        self, name: str, values: NDArray[np.float64] | float, *, difference: bool = False
    ) -> NDArray[np.float64]:
        try:
            return convert(values, self._si_unit(name), self._unit(name), difference=difference)
        except UnitError as error:
            raise InputError(f"{name}: {error}") from None
