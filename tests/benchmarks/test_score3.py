"""The set whose forms lie apart and half of whose recordings begin in the middle. No form is named here."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from blind_cases import apart, cases, table
from blind_cases.beginnings import IN_THE_MIDDLE, MOVING, STARTS, begun, rates
from blind_cases.setups import SIGNALS, Design, draw
from rig.effect import Effect
from rig.muscle import MuscleParameters

pytestmark = pytest.mark.full  # of the measuring, not of the product

WHICH, COUNT = "score3", 400
LINES = apart.module("lines")
CHECKS = apart.module("checks")
NEW: list[table.Form] = [*LINES.FORMS, *LINES.STRANGE]
FIRST = [cases.case_of(WHICH, n) for n in range(COUNT)]


def _kind(form: table.Form) -> type[Effect]:
    return type(form.make(np.random.default_rng(1), MuscleParameters())(min(1.0, form.high)))


# --- the archive ------------------------------------------------------------------------------


def test_the_archive_is_what_its_folder_gives(tmp_path: Path) -> None:
    apart.unpack(tmp_path)
    apart.pack(tmp_path, tmp_path / "first.zip")
    for file in (tmp_path / apart.PACKAGE).iterdir():
        file.touch()
    apart.pack(tmp_path, tmp_path / "again.zip")
    assert (tmp_path / "first.zip").read_bytes() == (tmp_path / "again.zip").read_bytes()
    apart.unpack(tmp_path / "other", tmp_path / "first.zip")
    for file in (tmp_path / apart.PACKAGE).iterdir():
        assert file.read_bytes() == (tmp_path / "other" / apart.PACKAGE / file.name).read_bytes()


def test_nothing_but_the_set_itself_opens_the_archive() -> None:
    code = (
        "import sys; from blind_cases import cases; cases.case_of('tuning2', 3);"
        "cases.case_of('score2', 3);"
        "assert not any('score3_forms' in name for name in (*sys.modules, *sys.path));"
        "cases.case_of('score3', 3); assert 'score3_forms.lines' in sys.modules"
    )
    path = ":".join(place for place in sys.path if place != str(apart.ARCHIVE))
    subprocess.run([sys.executable, "-c", code], check=True, env={"PYTHONPATH": path})


# --- the forms --------------------------------------------------------------------------------


@pytest.mark.parametrize("number", range(len(CHECKS.CHECKS)))
def test_each_form_gives_its_limit_or_keeps_what_it_conserves(number: int) -> None:
    CHECKS.CHECKS[number]()


def test_forms_are_new_of_each_family_in_none_and_each_is_checked() -> None:
    families = Counter(form.family for form in NEW)
    assert set(families) == {*table.FAMILIES, "none_of_these"} and families["none_of_these"] >= 6
    kinds = [_kind(form) for form in NEW]
    assert len(set(kinds)) == len(kinds) and set(kinds) <= CHECKS.CHECKED
    known = {(f.family, f.name) for f in (*table.FORMS, *table.STRANGE)}
    assert not known & {(form.family, form.name) for form in NEW}
    for form, kind in zip(NEW, kinds, strict=True):
        assert (form.family, form.name) == (kind.family, kind.form) and not form.catalogue


# --- where recordings begin -------------------------------------------------------------------


def test_half_of_each_group_begins_in_the_middle_and_half_of_those_say_so() -> None:
    for group in cases.GROUPS:
        starts = Counter(
            c.start for c in FIRST if c.group == group and c.design.bench != "VesselOrifice"
        )
        middle = sum(starts[name] for name in IN_THE_MIDDLE)
        assert abs(middle - starts["rest"]) <= 1
        assert abs(starts["stated"] - starts["unstated"]) <= 1 and set(starts) <= set(STARTS)
    assert {c.start for c in FIRST if c.design.bench == "VesselOrifice"} == {"rest"}
    assert {cases.case_of("tuning3", n).start for n in range(80)} == set(STARTS)
    assert all(cases.case_of("tuning2", n).start is None for n in range(80))
    assert "start" not in cases.outline(cases.case_of("score2", 0))


def _small(start: str, bench: str = "TankFilling") -> cases.Case:
    design = Design(bench, SIGNALS[bench][0][0], 50.0, 3)
    case = next(c for c in FIRST if c.group == "null")
    return replace(case, design=design, start=start)


@pytest.mark.parametrize("bench", ["TankFilling", "VerticalLoad"])
def test_a_recording_begins_in_motion_with_what_the_whole_run_has(bench: str) -> None:
    case = _small("stated", bench)
    setup = draw(case.rng(1), case.design).driven()
    late = begun(setup, case.rng(4))
    for trial, whole, part in zip(late.plan, setup.simulate(), late.simulate(), strict=True):
        first = setup.signals[0]
        assert 0.1 * trial.samples < trial.begin < 0.61 * trial.samples
        assert rates(trial, whole[first])[trial.begin] >= MOVING
        assert all(np.array_equal(part[name], whole[name][trial.begin :]) for name in part)
    assert len(late.roles()) == sum(trial.samples - trial.begin for trial in late.plan)


@pytest.mark.parametrize("start", IN_THE_MIDDLE)
def test_the_truth_leaves_its_noise_where_a_start_is_estimated(start: str, tmp_path: Path) -> None:
    """Not all of it: start values of each run are fitted to the noise."""
    made = cases.make(_small(start))
    cases.write(made, tmp_path)
    truth = pam.compare(pam.read(tmp_path), parameters={p.name: p.true for p in made.setup.free})
    for role, noise in made.description["noise"].items():
        sigma = {n: float(truth.data.signals[n].sigma or np.nan) for n in noise}
        total = sum(one["mean_square"] * one["samples"] / sigma[n] ** 2 for n, one in noise.items())
        floor = total / sum(one["samples"] for one in noise.values())
        assert truth.chi2_reduced(role) == pytest.approx(floor, rel=0.1), role
