"""Points at rest by the real command: the page's example, the order of rows, a loop of dry friction."""

from __future__ import annotations

import importlib.util
import json
import re
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
from scipy.optimize import brentq

from tests.cli.conftest import ROOT, Outcome
from tests.documentation.pages import blocks

Command = Callable[..., Outcome]
EXAMPLE = ROOT / "examples" / "static-map"


def loop(noise: int = 7) -> list[str]:
    """A muscle in other words: forces by the braid's angle, Coulomb friction of 12 N, noise of 0.1 mm."""
    rng, rows = np.random.default_rng(noise), []
    thread, turns = float(np.hypot(0.24, 2 * np.pi * 0.02)), 2.0
    largest = thread / (turns * np.pi)  # diameter at 90 degrees

    def pull(p: float, x: float) -> float:
        cosine = (0.24 - x) / thread
        return float(np.pi * largest**2 * p / 4 * (3 * cosine**2 - 1))

    for load in (20.0, 60.0, 100.0):
        for way, word in ((1, "up"), (-1, "down")):
            for p in np.arange(80e3, 400e3, 20e3)[::way]:
                at = brentq(
                    lambda x, p=p, load=load, way=way: pull(p, x) - load - 12.0 * way, -0.02, 0.1
                )
                rows.append(f"{p / 1e3:g},{load:g},{1e3 * at + rng.normal(0, 0.1):.4f},{word}")
    return rows


def test_the_page(command: Command, place: Path) -> None:
    folder = place / "map"
    folder.mkdir()
    (table,), (toml,) = (blocks("data-sets.md#Points at rest", kind) for kind in ("csv", "toml"))
    (folder / "map.csv").write_text(table)
    (folder / "experiment.toml").write_text(toml)
    errors = []
    for words in (["compare", "map", "--report", "r.html"], ["fit", "map", "-o", "p.json"]):
        outcome = command(*words, "--json", "r.json") if words[0] == "compare" else command(*words)
        assert outcome.status == 0, outcome.err
        errors.append(float(re.findall(r"fit +F +rms error +([\d.e+]+) N", outcome.out)[0]))
    assert errors[1] < 0.5 * errors[0]
    report = (place / "r.html").read_text()
    assert "over x" in report and "time [s]" not in report
    runs = json.loads((place / "r.json").read_text())["runs"]
    assert [run["role"] for run in runs].count("holdout") == 1


def example() -> ModuleType:
    spec = importlib.util.spec_from_file_location("static_map", EXAMPLE / "run.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
