"""An interrupted fit goes on where it stopped and ends where it would have, to the last bit; no other fit does."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim import InputError
from pam_cosim.fitting import Fit, FitProgress
from pam_cosim.measurement import Signal
from pam_cosim.measurement.start import Start
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
    assert len(json.loads(file.read_text())["answers"]) >= 3
    before = len(runs)
    resumed = pam.fit(data, method=method, resume=file)
    assert resumed.values == whole.values
    again_counts = (
        method == "differential-evolution"
    )  # it comes to some points twice, which are simulated once now
    assert (
        resumed.evaluations < whole.evaluations
        if again_counts
        else resumed.evaluations == whole.evaluations
    )
    assert resumed.convergence.chi2_reduced.tolist() == whole.convergence.chi2_reduced.tolist()
    assert (
        len(runs) - before <= whole.evaluations + 2
    )  # those of combinations and the comparison; none twice
    runs.clear()
    again = pam.fit(data, method=method, resume=file)
    assert again.values == whole.values and len(runs) <= 3


def count_runs(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    runs: list[int] = []
    plain = Simulator.run

    def counted(self, *args, **words):  # type: ignore[no-untyped-def]
        if len(args[0]) > 1:  # a look at the very start of a run is none
            runs.append(1)
        return plain(self, *args, **words)

    monkeypatch.setattr(Simulator, "run", counted)
    return runs


def test_file_of_another_fit_is_refused(tmp_path: Path) -> None:
    data, file = vessel_data(), tmp_path / "fit.progress"
    pam.fit(data, resume=file)
    kept = file.read_bytes()
    hotter = replace(
        data, runs=(replace(data.runs[0], measurements={"p": data.runs[0].measurements["p"] + 1}),)
    )
    later = replace(
        data, runs=(replace(data.runs[0], start=Start("measured", before={"u": 1.0}, seconds=5.0)),)
    )
    wider = replace(data, fit={**data.fit, "tank.n": replace(data.fit["tank.n"], max=1.39)})
    for call, message in (
        (lambda: pam.fit(data, "TankFilling", resume=file), "no parameter|another model"),
        (
            lambda: pam.fit(hotter, resume=file),
            "keeps a fit to other data; name another file, or remove this one",
        ),
        (lambda: pam.fit(later, resume=file), "keeps a fit to other data"),
        (lambda: pam.fit(wider, resume=file), "other parameters, bounds or priors"),
        (lambda: pam.fit(data, method="multi-start", resume=file), "by another method"),
    ):
        with pytest.raises(InputError, match=message):
            call()
    assert file.read_bytes() == kept


@pytest.mark.parametrize(
    "text", ["", "{}", "[1, 2]", '{"kind": "pam-cosim fit in progress", "version": 1}']
)
def test_what_is_no_such_file_is_refused_and_left(text: str, tmp_path: Path) -> None:
    file = tmp_path / "fit.progress"
    file.write_text(text)
    with pytest.raises(InputError):
        pam.fit(vessel_data(), resume=file)
    assert file.read_text() == text


@pytest.mark.parametrize(
    ("place", "content"),
    [
        (0, 3),
        (0, "square"),
        (1, 10**400),
        (1, [float("inf"), 1.0]),
        (1, [None, 1.0]),
        (2, -1),
        (2, 10**400),
        (2, 1.5),
        (3, "x"),
        (3, [[1.0]]),
        (3, float("nan")),
    ],
    ids=lambda one: str(one)[:20],
)
def test_a_damaged_answer_is_refused_and_the_file_left(
    progress: str, tmp_path: Path, place: int, content: object
) -> None:
    document, file = json.loads(progress), tmp_path / "fit.progress"
    for kind in ("squares", "triangle"):
        entry = next(one for one in document["answers"] if one[0] == kind)
        entry[place] = content
        file.write_text(json.dumps(document))
        with pytest.raises(InputError, match="damaged"):
            pam.fit(vessel_data(), resume=file)
        assert file.read_text() == json.dumps(document)
        document = json.loads(progress)


@pytest.fixture(scope="module")
def progress(tmp_path_factory: pytest.TempPathFactory) -> str:
    """What a fit keeps."""
    file = tmp_path_factory.mktemp("fit") / "fit.progress"
    pam.fit(vessel_data(), resume=file)
    return file.read_text()


def test_standing_reads_as_a_person_would_say_it() -> None:
    """Errors are of all fitted runs, also of signals that the last one does not have."""
    told: list[FitProgress] = []
    first = vessel_data()
    (run,) = first.runs
    last = replace(run, name="last", measurements={"T": np.full(len(run.time), 293.15)})
    signals = {**first.signals, "T": Signal("T", "K", 30.0)}
    data = replace(first, runs=(run, last), signals=signals)
    result: Fit = pam.fit(data, progress=told.append)
    assert (
        str(FitProgress(23, 4.2, {"p": 1234.0}, {"p": "Pa"}))
        == "23 simulations, p off by 1.23 kPa rms, chi2 4.2"
    )
    assert [s.evaluations for s in told] == list(range(1, len(told) + 1))
    assert told[-1].rmse == {
        name: pytest.approx(score.rmse, rel=1e-3)
        for name, score in result.comparison.scores["fit"].items()
    }
    assert result.convergence.chi2_reduced[-1] == pytest.approx(
        result.residuals["fit"].chi2_reduced, rel=1e-6
    )
