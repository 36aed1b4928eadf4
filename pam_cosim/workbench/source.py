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

    def read(self, model: str | None) -> DataSet:
        """The measurement for a model, with its noise and the start of every run; as ``study.read``.

        Raises:
            InputError: the data set cannot be read.
        """
        return self._complete(study.read(self.folder, model=model, files=self.files), model)

    def read_again(
        self,
        data: DataSet,
        cuts: Mapping[str, Ends],
        starts: Mapping[str, str],
        model: str | None = None,
    ) -> DataSet:
        """The measurement with the roles that runs have now, cut and begun as chosen.

        Args:
            data: as it is now.
            cuts: first and last time [s] of runs, by name.
            starts: how runs begin, by name.
            model: default: that of the data.

        Raises:
            InputError: the data set cannot be read with these.
        """
        model = model or data.unmapped or data.model
        roles = {run.name: run.role for run in data.runs}
        read = study.read(
            self.folder, model=model, files=self.files, roles=roles, cuts=cuts, starts=starts
        )
        return self._complete(read, model)

    def _complete(self, data: DataSet, model: str | None) -> DataSet:
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
