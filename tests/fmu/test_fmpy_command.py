"""The command ``fmpy`` on every bench: info, validate, simulate, of both kinds; and its plot in a browser.

On every bench its entry point is called in this process, which is ten times cheaper; processes of their own run the
README's lines.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
import time
from collections.abc import Callable
from functools import cache
from pathlib import Path

import fmpy
import fmpy.cli
import numpy as np
import pytest
from fmpy.util import read_csv
from lxml import etree

import pam_cosim as pam
from pam_cosim.study import benches
from tests.fmu.test_conformance import _read, _schema

VERSIONS = ["2.0", pytest.param("3.0", marks=pytest.mark.full)]
ROOT = Path(__file__).parents[2]
QUICK = ("Isotonic", "TankFilling", "VesselOrifice")

# FMPy drives our own solver (co-simulation) over the same communication points: only the times differ, by rounding.
SAME_SOLVER = 1e-12  # of the greatest value
# FMPy's CVode at a tolerance of 1e-8 is another method with a hundredth of our local error: what is left is ours. The
# default tolerance of 1e-6 holds for a step; ten of them are granted for a run (the worst bench takes two and a half).
OTHER_SOLVER = 1e-5  # of the range


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """The command ``fmpy`` with these words; what it prints."""

    def call(*words: object) -> str:
        monkeypatch.setattr(sys, "argv", ["fmpy", *map(str, words)])
        capsys.readouterr()
        try:
            fmpy.cli.main()
        except SystemExit as end:
            assert not end.code, capsys.readouterr()
        return capsys.readouterr().out

    return call


@cache
def ours(bench: str) -> pam.Trajectory:
    return pam.simulate(bench)


def largest_difference(result: np.ndarray, bench: str) -> dict[str, tuple[float, float, float]]:
    """By output: the largest difference to ``pam.simulate``, the range and the greatest value [SI]."""
    own = ours(bench)
    assert set(result.dtype.names) == {"time", *own.values}
    assert result["time"][0] == own.time[0] and result["time"][-1] == pytest.approx(own.time[-1])
    differences = {}
    for name, values in own.values.items():
        there = np.interp(result["time"], own.time, values)
        differences[name] = (
            float(np.abs(there - result[name]).max()),
            float(np.ptp(values)),
            float(np.abs(values).max()),
        )
    return differences


@pytest.mark.parametrize(
    ("bench", "fmi"),
    [
        pytest.param(bench, fmi, marks=[pytest.mark.full] * (bench not in QUICK or fmi == "3.0"))
        for bench in benches()
        for fmi in ("2.0", "3.0")
        if fmi == "2.0" or bench in QUICK
    ],
)
def test_every_bench(run: Callable[..., str], bench: str, fmi: str, tmp_path: Path) -> None:
    path, result = pam.build(bench, fmi=fmi), tmp_path / "result.csv"
    said, face = run("info", path), pam.describe(bench)
    assert re.search(rf"FMI Version\s+{re.escape(fmi)}", said)
    assert all(name in said for name in [*face.inputs, *face.outputs])
    assert run("validate", path) == "No problems found.\n"
    _schema(fmi, "ModelDescription").assertValid(_read(path, "modelDescription.xml"))
    run("simulate", path, "--interface-type", "CoSimulation", "--output-file", result)
    for name, (difference, _, greatest) in largest_difference(read_csv(str(result)), bench).items():
        assert difference <= SAME_SOLVER * greatest, name
    if fmpy.read_model_description(str(path)).modelExchange is None:
        assert "Co-Simulation" in said and "Model Exchange" not in said
        return
    exchange = [
        "--interface-type",
        "ModelExchange",
        "--relative-tolerance",
        "1e-8",
        "--dont-record-events",
    ]
    run("simulate", path, *exchange, "--output-file", result)
    for name, (difference, span, greatest) in largest_difference(
        read_csv(str(result)), bench
    ).items():
        assert difference <= OTHER_SOLVER * span + SAME_SOLVER * greatest, name


def test_settings_mean_the_same_to_fmpy(run: Callable[..., str], tmp_path: Path) -> None:
    """Its start values of inputs are our inputs held constant."""
    result = tmp_path / "result.csv"
    values = ["p_supply", "138e3", "u_in", "0.3", "tank.V", "1e-3"]
    run("simulate", pam.build("TankFilling"), "--start-values", *values, "--output-file", result)
    theirs = read_csv(str(result))
    own = pam.simulate("TankFilling", {"p_supply": "138 kPa", "u_in": "300 mA", "tank.V": "1 l"})
    assert theirs["p"] == pytest.approx(own["p"], rel=1e-9)
    assert own["p"][-1] == pytest.approx(138e3, rel=1e-3)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_start_values_of_states_mean_the_same_to_fmpy(
    run: Callable[..., str], tmp_path: Path, fmi: str
) -> None:
    """Also of a state whose usual start value follows from parameters."""
    result, path = tmp_path / "result.csv", pam.build("Isotonic", fmi=fmi)
    values = {"muscle.gas.p": 219325.0, "load.s": 0.031, "u_in": 0.0, "u_out": 0.0}
    words = [str(word) for item in values.items() for word in item]
    for kind in ("CoSimulation", "ModelExchange"):
        run(
            "simulate",
            path,
            "--interface-type",
            kind,
            "--start-values",
            *words,
            "--output-file",
            result,
        )
        theirs = read_csv(str(result))
        own = pam.simulate("Isotonic", values)
        assert theirs["p"][0] == own["p"][0] == pytest.approx(118e3)
        assert theirs["x"][0] == own["x"][0] == 0.031
        assert theirs["p"][-1] == pytest.approx(own["p"][-1], rel=1e-4)


README = (ROOT / "README.md").read_text()
FETCH = (
    "import sys, urllib.request as u; open(sys.argv[1], 'wb').write(u.urlopen(sys.argv[2]).read())"
)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_the_line_of_the_readme_shows_its_plot(tmp_path: Path, fmi: str) -> None:
    """As it stands there, in processes of their own; the browser is a program in the background
    that keeps the page it is sent to."""
    [line] = re.findall(r"`(fmpy simulate [^`]*)`", " ".join(README.split()))
    assert line.endswith("--show-plot") and "`pam-cosim build`, then" in README
    programs, page = Path(sys.executable).parent, tmp_path / "page.html"
    browser = shlex.join([sys.executable, "-c", FETCH, str(page)])
    environment = {**os.environ, "BROWSER": f"{browser} %s &", "PYTHONPATH": str(ROOT)}
    environment.pop("DISPLAY", None)
    words = [sys.executable, "-m", "pam_cosim", "build", "TankFilling", "--fmi", fmi]
    subprocess.run(
        words, cwd=tmp_path, env=environment, check=True, capture_output=True, timeout=300
    )
    words = [str(programs / "fmpy"), *line.split()[1:]]
    completed = subprocess.run(
        words, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120
    )
    assert completed.returncode == 0 and "Traceback" not in completed.stderr, completed.stderr
    shown = kept(page)
    assert etree.HTML(shown).xpath("//div[contains(@class, 'plotly-graph-div')]")
    drawn = shown.rpartition("Plotly.newPlot(")[2]
    assert all(f'"text":"{title}"' in drawn for title in ("time [s]", "p [kPa]", "T [degC]")), (
        drawn[-2000:]
    )


def kept(page: Path) -> str:
    """The page; the browser may outlive the command by a moment."""
    for _ in range(100):
        if page.exists() and (text := page.read_text()).rstrip().endswith("</html>"):
            return text
        time.sleep(0.1)
    pytest.fail("the browser has kept no page")
