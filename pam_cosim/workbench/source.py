"""The measurement of a study: its folder, read again after something is chosen in place of what the data set states."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pam_cosim import study
from pam_cosim.measurement import DataSet
from pam_cosim.problems import ParameterValue
from pam_cosim.study.problems import data_with_starts, problem

OF_RUNS = ("roles", "cuts", "starts")
"""What is chosen of runs, which holds for every model; of values, free parameters and signals it may not."""


@dataclass
class MeasurementSource:
    """A folder with a data set.

    Args:
        folder: of the data set.
        files: further Modelica files.
    """

    folder: Path
    files: tuple[Path, ...] = ()
    _whole: dict[str, DataSet] = field(default_factory=dict)

    def read(
        self, model: str | None, chosen: Mapping[str, Any] | None = None
    ) -> tuple[DataSet, tuple[ParameterValue, ...]]:
        """The measurement for a model, with its noise and the start of every run, and every value with its source.

        Args:
            model: default: the bench of the data set.
            chosen: roles, cuts and starts of runs, as ``study.read`` takes them; "signals", as
                ``DataSet.with_signals``; "values" [SI] and "free" parameters, as ``study.problem``.

        Raises:
            InputError: the data set cannot be read with these.
        """
        choices = chosen or {}
        of_runs = {key: choices[key] for key in OF_RUNS if key in choices}
        data = study.read(self.folder, model=model, files=self.files, **of_runs)
        if "signals" in choices:
            data = data.with_signals(choices["signals"])
        values, free = choices.get("values"), choices.get("free")
        resolved = problem(data, model, files=self.files, values=values, free=free)
        return data_with_starts(resolved), resolved.values

    def whole(self, data: DataSet) -> DataSet:
        """The same with all recorded rows; starts and noise are not completed."""
        cut = {run.name: (None, None) for run in data.runs if run.recorded}
        if not cut:
            return data
        key = " ".join([data.model, *cut])
        if key not in self._whole:
            model = data.unmapped or data.model
            self._whole = {key: study.read(self.folder, model=model, files=self.files, cuts=cut)}
        return self._whole[key]
