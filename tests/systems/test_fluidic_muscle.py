"""A published isometric table of a fluidic muscle, from its raw numbers to a model and a verdict."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import least_squares

import pam_cosim as pam
from tests.library.test_muscles import A2, table

HELD_OUT = 2
SIGMA = 1.0
"""[N] Stated noise: the table has three digits and steps of 1/6 N."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Table A2 of Martens and Boblan 2017: a run for each length, the one in the middle held out."""
    pam.bench(
        "imposed-pressure", "imposed-length", "physical", measure="F", output=tmp_path / "Rig.mo"
    )
    pressures, lengths, pulls = table(A2)
    turns = lengths[0] * np.tan(np.radians(28.5)) / (np.pi * 0.0136)
    toml = f"""title = "DMSP-10-250, isometric"
model = "Rig.mo"
[signals.F]
sigma = "{SIGMA} N"
[parameters]
"muscle.L0" = "250 mm"
"muscle.turns" = {turns}
"muscle.t_wall" = "1.8 mm"
"muscle.mu_fb" = 0
"muscle.mu_d" = 0
[fit]
"muscle.D0" = {{ min = "9 mm", max = "16 mm", start = "13.6 mm" }}
"""
    for i, length in enumerate(lengths):
        s = 1e3 * (lengths[0] - length)
        rows = [f"0,{pressures[0]},{s},"]  # a second in which the muscle is filled
        rows += [
            f"{k + 1},{p},{s},{force}"
            for k, (p, force) in enumerate(zip(pressures, pulls[:, i], strict=True))
        ]
        (tmp_path / f"{i}.csv").write_text(
            "\n".join(["time [s],p [Pa],s [mm],F [N]", *rows]) + "\n"
        )
        role = "holdout" if i == HELD_OUT else "fit"
        toml += f'[[runs]]\nfile = "{i}.csv"\nrole = "{role}"\n[runs.parameters]\n"drive.s_start" = "{s} mm"\n'
    (tmp_path / "experiment.toml").write_text(toml)
    return tmp_path


def by_formula() -> tuple[float, float]:
    """Root mean square [N] that Sarosi's six coefficients leave of the fitted and of the held-out lengths."""
    pressures, lengths, pulls = table(A2)
    p, eps = np.meshgrid(pressures / 1e5, 1 - lengths / lengths[0], indexing="ij")

    def residual(a: np.ndarray) -> np.ndarray:
        law = (a[0] * p + a[1]) * np.exp(-eps / a[2]) - a[3] * p * eps + a[4] * p - a[5]
        return np.asarray(np.maximum(law, 0) - pulls)

    held = np.arange(len(lengths)) == HELD_OUT
    fitted = least_squares(
        lambda a: residual(a)[:, ~held].ravel(),
        [0.0, 160, 0.025, 290, 90, 200],
        x_scale=[1, 100, 0.01, 100, 100, 100],
    )
    left = residual(fitted.x)
    return float(np.sqrt(np.mean(left[:, ~held] ** 2))), float(np.sqrt(np.mean(left[:, held] ** 2)))


def left(fit: pam.Fit) -> tuple[float, float]:
    """Root mean square [N] of what is left of the fitted and of the held-out lengths."""
    scores = fit.comparison.scores
    return scores["fit"]["F"].rmse, scores["holdout"]["F"].rmse


def test_an_effect_meets_a_published_table_as_well_as_a_formula_fitted_to_it(folder: Path) -> None:
    """Six coefficients here and there; five lengths, one of them held out."""
    pam.add(["SarosiEnds"], str(folder / "Rig.mo"), folder / "Better.mo")
    bounds = {
        "a_5": (0.2, 3),
        "a_4": (1, 10),
        "a_1": (-0.5, 0.5),
        "p_0": ("-1 bar", "5 bar"),
        "p_w": ("0 bar", "10 bar"),
        "eps_w": (0.005, 0.06),
    }
    free = "".join(
        f'"muscle.braid.{n}" = {{ min = {low!r}, max = {high!r} }}\n'
        for n, (low, high) in bounds.items()
    )
    toml = (folder / "experiment.toml").read_text()
    diameter = next(line for line in toml.splitlines() if line.startswith('"muscle.D0"'))
    toml = toml.replace(f"[fit]\n{diameter}\n", f'"muscle.D0" = "13.6 mm"\n[fit]\n{free}')
    (folder / "experiment.toml").write_text(toml)
    better, rig = str(folder / "Better.mo"), [folder / "Rig.mo"]
    made = left(pam.fit(pam.read(folder, model=better, files=rig), better, files=rig))
    assert made == pytest.approx(by_formula(), rel=0.1)


@pytest.mark.full
def test_the_catalogue_finds_it(folder: Path, workers: int | None) -> None:
    diagnosis = pam.diagnose(pam.read(folder), explain=False, workers=workers)
    assert diagnosis.verdict.effects == ("SarosiEnds",)
    for ours, formula in zip(left(diagnosis.candidates[0].fit), by_formula(), strict=True):
        assert ours < 1.1 * formula
