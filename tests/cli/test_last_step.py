"""The last step keeps what was found: ``compare`` of what ``diagnose -o`` writes prints the verdict's numbers."""

from __future__ import annotations

import json
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import pam_cosim as pam
from tests.cli.conftest import Outcome
from tests.cli.test_commands import done

Command = Callable[..., Outcome]


def shown(command: Command, words: list[str]) -> dict[str, Any]:
    """The scores by role that ``compare`` shows."""
    done(command("compare", *words, "--json", "compared.json"))
    roles: dict[str, Any] = json.loads(Path("compared.json").read_text(encoding="utf-8"))["roles"]
    return roles


def check_loop(
    command: Command, folder: Path, workers: int | None, *further: str
) -> dict[str, Any]:
    """Diagnoses, compares the model that was written, and asks for equal numbers; returns the document."""
    number = [] if workers is None else ["--workers", workers]
    files = ["-o", "Better.mo", "--json", "d.json", "--save", "d.npz"]
    said = done(command("diagnose", folder, *files, *number, *further))
    document: dict[str, Any] = json.loads(Path("d.json").read_text(encoding="utf-8"))
    (line,) = [
        one for one in said.out.splitlines() if one.startswith("compare it: pam-cosim compare ")
    ]
    compared = shown(command, shlex.split(line)[4:])
    for role in ("fit", "holdout"):
        if document["final"][role]:
            assert compared[role]["signals"] == document["final"][role]["signals"]
    return document


@pytest.fixture
def started(data: Path) -> Path:
    """The vessel's data set, with a start for what is fitted: it must not stand in the place of what was found."""
    file = data / "experiment.toml"
    text = file.read_text(encoding="utf-8").replace(
        "{ min = 0.5, max = 1.1 }", "{ min = 0.5, max = 1.1, start = 0.6 }"
    )
    file.write_text(text, encoding="utf-8")
    return data


def test_vessel(command: Command, started: Path, workers: int | None) -> None:
    document = check_loop(command, started, workers)
    assert document["final"]["fit"]["chi2_reduced"] <= document["base"]["chi2_reduced"]
    # the same by the values in the document, beside the model without them
    done(command("add --from d.json -o Again.mo"))
    assert Path("Again.mo").read_text().replace("Again", "Better") == Path("Better.mo").read_text()


def test_in_python(started: Path, place: Path) -> None:
    data = pam.read(started)
    fitted = pam.fit(data)
    pam.add(fitted, output=place / "Fitted.mo")
    compared = pam.compare(data, str(place / "Fitted.mo"))
    assert compared.scores["all"] == fitted.comparison.scores["all"]
    again = pam.compare(pam.read(started, model=str(place / "Fitted.mo")))
    assert again.scores["all"] == fitted.comparison.scores["all"]
    assert pam.compare(data).scores["all"] != compared.scores["all"]


def test_values_of_another_model_are_refused_with_what_to_do(
    command: Command, data: Path, place: Path
) -> None:
    Path("d.json").write_text(
        json.dumps(
            {
                "final": {
                    "model": "VesselOrifice",
                    "effects": ["EnergyGas"],
                    "parameters": {"tank.gas.h": 8.0},
                }
            }
        )
    )
    refused = command("compare", data, "--params", "d.json")
    assert refused.status == 2 and "EnergyGas" in refused.err and "add --from d.json" in refused.err


@pytest.mark.parametrize(
    "content, said",
    [
        ({"title": "x"}, "no number"),
        (
            {"parameters": {"orifice.C_d": 0.7, "nonsense": 1.0}, "model": "VesselOrifice"},
            "'nonsense'",
        ),
        ({"parameters": {}, "model": 3}, "model"),
        ({"parameters": {}, "effects": "EnergyGas"}, "effects"),
        ([1, 2], "object"),
    ],
)
def test_damaged_products(command: Command, place: Path, content: object, said: str) -> None:
    Path("d.json").write_text(json.dumps(content))
    refused = command("add --from d.json --to VesselOrifice -o Better.mo")
    assert refused.status == 2 and said in refused.err and "d.json" in refused.err + "d.json"
    assert not Path("Better.mo").exists()
