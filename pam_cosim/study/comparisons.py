"""A model against measurements, without fitting anything."""

from __future__ import annotations

from collections.abc import Mapping

from pam_cosim.comparison import Comparison
from pam_cosim.comparison import compare as _compare
from pam_cosim.fitting import (
    estimated_starts,
    runs_without_start,
)
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import START_VALUES
from pam_cosim.model.settings import Setting
from pam_cosim.simulation.models import Paths, describe, opened
from pam_cosim.study.data_sets import (
    data_with_starts,
    few_rows,
    for_model,
    overriding,
    values_of_runs,
)


def compare(
    data: DataSet,
    model: str | None = None,
    parameters: Mapping[str, Setting] | None = None,
    *,
    files: Paths = (),
    timeout: float | None = None,
) -> Comparison:
    """Simulates every run of ``data`` with ``model`` (default: its bench) and scores the differences.

    ``parameters`` are further values, which take the place of those that the data set states, and ``timeout`` a limit,
    as in ``simulate``.
    """
    data = for_model(data, model, files)
    name = data.model_for(model)
    interface = describe(name, files)
    values = overriding(values_of_runs(parameters or {}, data, interface), data)
    data = data_with_starts(data, name, values, files, timeout)
    starts = [START_VALUES] * data.estimates_starts
    with opened(name, files, starts, timeout, brief=few_rows(data)) as simulator:
        found = estimated_starts(
            simulator, data, runs_without_start(data, values, interface), values
        )
        return _compare(simulator, data, values | {name: e.value for name, e in found.items()})
