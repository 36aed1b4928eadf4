"""An interrupted fit goes on where it stopped and ends where it would have, to the last bit; no other fit does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim.fitting import FitProgress
from pam_cosim.simulation import Simulator
from tests.fitting.models import vessel_data


class Stop(Exception):
    pass


def stop_after(count: int) -> Callable[[FitProgress], None]:
    def progress(standing: FitProgress) -> None:
        if standing.evaluations >= count:
            raise Stop

    return progress


@pytest.mark.parametrize("method", ["least-squares", "particle-swarm", "differential-evolution"])
def test_it_ends_as_if_it_had_not_been_interrupted(
    method: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data, file = vessel_data(), tmp_path / "fit.progress"
    whole = pam.fit(data, method=method)
    runs = count_runs(monkeypatch)
    with pytest.raises(Stop):
        pam.fit(data, method=method, resume=file, progress=stop_after(4))
    assert len(runs) >= 3
    resumed = pam.fit(data, method=method, resume=file)
    assert resumed.values == whole.values and resumed.evaluations == whole.evaluations
    assert resumed.convergence.chi2_reduced.tolist() == whole.convergence.chi2_reduced.tolist()
    assert len(runs) <= whole.evaluations + 3  # with those of the comparison; none twice
    runs.clear()
    again = pam.fit(data, method=method, resume=file)
    assert again.values == whole.values and not runs


def count_runs(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    runs: list[int] = []
    plain = Simulator.run

    def counted(self, *args, **words):  # type: ignore[no-untyped-def]
        if len(args[0]) > 1:  # a look at the very start of a run is none
            runs.append(1)
        return plain(self, *args, **words)

    monkeypatch.setattr(Simulator, "run", counted)
    return runs


def test_another_fit_of_the_model_may_use_the_file(tmp_path: Path) -> None:
    data, file = vessel_data(), tmp_path / "fit.progress"
    pam.fit(data, resume=file)
    wider = replace(data, fit={**data.fit, "tank.n": replace(data.fit["tank.n"], max=1.39)})
    (run,) = data.runs
    hotter = replace(data, runs=(replace(run, measurements={"p": run.measurements["p"] + 1e3}),))
    for other in (wider, hotter):
        assert pam.fit(other, resume=file).values == pam.fit(other).values
