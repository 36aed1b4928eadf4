"""The product of a simulation: values over time, and its CSV file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from pam_cosim.arrays import Array
from pam_cosim.exports import Columns, Tabular, check_table_ending, write_table
from pam_cosim.files import written_whole
from pam_cosim.libraries import library
from pam_cosim.simulation.netcdf import with_netcdf_names
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Trajectory(Printed, Tabular):
    """Signals of one run.

    Attributes:
        time: (n,) [s].
        values: name to (n,) [``units``].
        units: name to unit.
        warnings: messages of the model on this run, such as assertions of level warning that do not hold.
        solver: a sentence, where not the FMU's own co-simulation made the run, but its model exchange with a solver.
    """

    time: Array
    values: Mapping[str, Array]
    units: Mapping[str, str]
    warnings: tuple[str, ...] = ()
    solver: str = ""

    def __getitem__(self, name: str) -> Array:
        return self.values[name]

    def frame_columns(self) -> Columns:
        """A column for each signal over "time" [s]."""
        signals = {name: (values, self.units.get(name, "")) for name, values in self.values.items()}
        return {"time": (self.time, "s"), **signals}

    def to_xarray(self) -> xarray.Dataset:
        """A variable for each signal over "time" [s], with its unit as an attribute."""
        return super().to_xarray().assign_attrs({"solver": self.solver} if self.solver else {})

    def __str__(self) -> str:
        count = len(self.time)
        span = f", {self.time[0]:g} s to {self.time[-1]:g} s" if count else ""
        lines = [f"{len(self.values)} signals at {count} times{span}"]
        for name, values in self.values.items():
            if count:
                low, high, last = (
                    format_quantity(float(v), self.units.get(name, ""))
                    for v in (values.min(), values.max(), values[-1])
                )
                lines.append(f"  {name}: from {low} to {high}, at the end {last}")
        return "\n".join(lines)

    def save(self, path: Path | str) -> Path:
        """Writes NetCDF (.nc), Parquet (.parquet) or CSV (.csv, or no ending), whole or not at all.

        Raises:
            InputError: the name ends otherwise, or the file cannot be written.
        """
        path = Path(path)
        check_table_ending(path)
        if path.suffix.lower() == ".nc":
            with written_whole(path) as name:
                with_netcdf_names(self.to_xarray()).to_netcdf(name, engine="h5netcdf")
        elif path.suffix.lower() == ".parquet":
            parquet, arrow = library("pyarrow.parquet"), library("pyarrow")
            columns = {
                f"{name} [{unit or '1'}]": values
                for name, (values, unit) in self.frame_columns().items()
            }
            with written_whole(path) as name:
                parquet.write_table(arrow.table(columns), name)
        else:
            self.to_csv(path)
        return path

    def to_csv(self, path: Path) -> Path:
        """Writes every number so that it reads back exactly; the file is written whole or not at all."""
        heads = [_header(name, self.units.get(name, "")) for name in self.values]
        columns = [self.time.tolist(), *(values.tolist() for values in self.values.values())]
        write_table(Path(path), (["time [s]", *heads], zip(*columns, strict=True)))
        return Path(path)


def _header(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name
