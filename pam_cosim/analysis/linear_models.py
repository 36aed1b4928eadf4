"""Linear models along a run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.analysis.linear import LinearModel
from pam_cosim.arrays import Array
from pam_cosim.files import Plain
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class LinearModels(Printed, Plain):
    """Linear models along a run, in the order of its times.

    Attributes:
        models: one for each time.
    """

    json_keys = "models"

    models: tuple[LinearModel, ...]

    @property
    def times(self) -> Array:
        """(k,) [s]."""
        return np.array([model.point.time for model in self.models])

    @property
    def poles(self) -> Array:
        """(k, n) complex [1/s], each row the slowest first."""
        return np.array([model.poles for model in self.models])

    def __len__(self) -> int:
        return len(self.models)

    def __getitem__(self, i: int) -> LinearModel:
        return self.models[i]

    def __str__(self) -> str:
        return "\n\n".join(map(_model_text, self.models))


def _model_text(model: LinearModel) -> str:
    """The time and the modes of one model."""
    return "\n".join([f"{model.point.time:g} s", *(f"  {line}" for line in model.modes_text())])
