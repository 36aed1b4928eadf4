"""The measurement of a study: its folder, read anew after runs are cut or begin otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from pam_cosim import study
from pam_cosim.measurement import DataSet
from pam_cosim.study.problems import data_with_starts, problem
from pam_cosim.workbench.state import Ends


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
        self,
        model: str | None,
        roles: Mapping[str, str] | None = None,
        cuts: Mapping[str, Ends] | None = None,
        starts: Mapping[str, str] | None = None,
    ) -> DataSet:
        """The measurement for a model, with its noise and the start of every run; as ``study.read``.

        Raises:
            InputError: the data set cannot be read, or not with these roles, cuts and starts.
        """
        data = study.read(
            self.folder, model=model, files=self.files, roles=roles, cuts=cuts, starts=starts
        )
        return data_with_starts(problem(data, model, files=self.files))

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
