"""The command ``check``."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

from tests.cli.conftest import Outcome, everything

Command = Callable[..., Outcome]


def test_it_prints_and_writes_what_the_data_determine(
    command: Command, data: Path, place: Path
) -> None:
    result = command("check", data, "--json", "told.json", "--workers", "0")
    assert result.status == 0, result.err
    for text in (
        "free parameters:",
        "orifice.C_d",
        "detectable families of effects",
        "what would help most:",
    ):
        assert text in result.out
    content = json.loads((place / "told.json").read_text())
    assert set(content["parameters"]) == {"orifice.C_d", "tank.n"}
    assert all(p["deviation"] > 0 for p in content["parameters"].values())
    assert {"gas_energy", "leak"} <= {e["family"] for e in content["effects"]}
    assert "elasticity" in content["no_place"]
    assert content["helps"][0]["what"]


def test_a_missing_folder_or_a_result_that_cannot_be_written_is_one_error(
    command: Command, data: Path
) -> None:
    before = everything(data)
    for words in (("check", "nowhere"), ("check", data, "--json", data / "one.csv")):
        result = command(*words)
        assert result.status == 2
        assert result.err.count("pam-cosim:") == 1
    assert everything(data) == before


def test_a_parameter_that_the_model_lacks_is_named(command: Command, data: Path) -> None:
    toml = data / "experiment.toml"
    toml.write_text(toml.read_text().replace("orifice.C_d", "orifice.C_e"))
    result = command("check", data)
    assert result.status == 2
    assert "orifice.C_e" in result.err
