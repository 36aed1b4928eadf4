"""What points at rest cannot show of an effect is not fitted: lags."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.diagnosis.search import search as searches
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.searches import fit_base_model
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.fitting import Fit
from pam_cosim.measurement import DataSet


def looked_at(data: DataSet) -> tuple[Search, Fit]:
    """A search beside the fitted base model of a data set."""
    subject = subject_of(data, None, [], 0, lambda message: None)
    with subject.simulator() as simulator:
        available_effects = subject.effects(simulator.interface)
        data, base = fit_base_model(simulator, subject.data, lambda message: None)
    return Search(
        subject.tree, subject.name, available_effects, data, subject.sources, workers=0
    ), base


@pytest.fixture(scope="module")
def at_rest(tmp_path_factory: pytest.TempPathFactory) -> tuple[Search, Fit]:
    folder = tmp_path_factory.mktemp("map")
    p, x = (one.ravel() for one in np.meshgrid(np.arange(1, 6) * 100.0, [0.0, 10.0, 20.0, 30.0]))
    pull = p * (0.9 - 0.02 * x) + 8.0 + np.random.default_rng(1).normal(0.0, 1.0, len(p))
    rows = "".join(f"{a:g},{b:g},{c:.2f}\n" for a, b, c in zip(p, x, pull, strict=True))
    (folder / "map.csv").write_text("p [kPa],x [mm],F [N]\n" + rows)
    (folder / "experiment.toml").write_text(
        'model = "PneumaticMuscle.Benches.QuasiStaticIsometric"\nkind = "static"\n[signals.F]\nsigma = "1 N"\n'
        '[fit]\n"muscle.D0" = { min = "15 mm", max = "40 mm" }\n[[runs]]\nfile = "map.csv"\n'
    )
    return looked_at(pam.read(folder))


def test_points_at_rest_tell_no_lag_of_a_load_cell_that_has_a_gain_too(
    at_rest: tuple[Search, Fit],
) -> None:
    search, base = at_rest
    general, lag, offset = search.probe(base, (), ["GeneralLoadCell", "ForceLag", "ForceOffset"])
    assert lag.silent and not general.silent and not offset.silent and offset.idle_parameters == ()
    assert [name.rpartition(".")[2] for name in general.idle_parameters] == ["tau", "r"]
    without = replace(search, inactive_parameters={"GeneralLoadCell": general.idle_parameters})
    assert without.cost["GeneralLoadCell"] == search.cost["GeneralLoadCell"] - 2
    (candidate,) = without.fit_briefly([searches.FitRequest(("GeneralLoadCell",), base.values)])
    left = set(general.linear.names) - set(general.idle_parameters)
    assert left <= set(candidate.fit.parameters) and not set(general.idle_parameters) & set(
        candidate.fit.parameters
    )
