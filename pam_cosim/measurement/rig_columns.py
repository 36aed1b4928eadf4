"""What the logger of a rig calls the inputs of a model, in which unit: columns of a data set, read backwards."""

from __future__ import annotations

from collections.abc import Collection
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.measurement.columns import sources_of, with_columns
from pam_cosim.measurement.data_set import FILE_NAME
from pam_cosim.measurement.experiment import read_experiment
from pam_cosim.measurement.experiment_tables import RunTable
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.read_run import layout_of
from pam_cosim.measurement.table import TIME, Table
from pam_cosim.model.interface import Interface
from pam_cosim.units import UnitError, convert


@dataclass(frozen=True)
class RigColumn:
    """A column of a file as a function of an input.

    Attributes:
        name, unit: of the column.
        gain, offset: the input [SI] is ``gain`` times the number in the file plus ``offset``.
    """

    name: str
    unit: str
    gain: float
    offset: float

    def numbers(self, values: Array) -> Array:
        """(n,) the values in the file where the input has these values [SI]."""
        return (np.asarray(values) - self.offset) / self.gain


def rig_columns(folder: Path, interface: Interface, names: Collection[str]) -> dict[str, RigColumn]:
    """The columns of the first run that inputs, or "time", are read from, by their names in the model.

    Those that are no linear function of one column are left out, and all where the data set is not there any more.

    Args:
        folder: of the data set.
        interface: of its model.
        names: of inputs, and "time".
    """
    with suppress(InputError, OSError, IndexError):
        run = read_experiment(folder / FILE_NAME).full_runs()[0]
        file = run.at("file").file_inside(run.file)
        table = read_table(file, layout_of(run.recording, run.columns, interface))
        columns = {name: _column(name, table, run, interface) for name in names}
        return {name: column for name, column in columns.items() if column is not None}
    return {}


def _column(name: str, table: Table, run: RunTable, interface: Interface) -> RigColumn | None:
    stated = {name: run.columns[name]} if name in run.columns else {}
    source_names = sources_of(stated) or {name}
    sources = [c for c in table.columns.values() if {c.name, c.heading} & source_names]
    unit = (
        "s" if name == TIME else interface.inputs[name].unit if name in interface.inputs else None
    )
    if len(sources) != 1 or unit is None:
        return None
    (source,) = sources
    probe = replace(table, columns={source.name: replace(source, values=np.arange(3.0), since="")})
    try:
        column = with_columns(probe, stated).columns[name]
        first, second, third = convert(column.values, column.unit, unit)
    except (InputError, UnitError, KeyError):
        return None
    gain = float(second - first)
    if not np.isfinite(gain) or gain == 0 or not np.isclose(third - second, gain):
        return None
    unit_text = (
        stated[name].unit if stated and stated[name].unit and not source.unit else source.unit
    )
    return RigColumn(source.name, unit_text or "", gain, float(first))
