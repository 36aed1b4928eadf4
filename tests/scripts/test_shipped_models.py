"""Models that the wheel carries: of some benches alone, the others' stay; what nobody would find goes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from scripts import shipped_models


@pytest.fixture
def shipped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where they go; each bench has one model, whose key begins with its name."""

    def models_of(tree: Any, bench: str, *rest: Any) -> Iterator[tuple[str, bytes]]:
        name = bench.rpartition(".")[2]
        yield f"{name:0<40}", name.encode()

    monkeypatch.setattr(shipped_models, "SHIPPED", tmp_path / "shipped")
    monkeypatch.setattr(shipped_models, "models_of", models_of)
    return tmp_path / "shipped"


def found(shipped: Path) -> dict[str, str]:
    """Archive by the name of the bench that the index finds there."""
    index = json.loads((shipped / "index.json").read_bytes())
    return {key.rstrip("0"): name for key, name in index.items()}


def archives(shipped: Path) -> set[str]:
    return {file.name for file in shipped.glob("*.xz")}


def test_a_bench_that_does_not_exist_is_refused(
    shipped: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert shipped_models.main(["Isotonic"]) == 0
    before = {file.name: file.read_bytes() for file in shipped.iterdir()}
    assert shipped_models.main(["Isotonic", "Typo"]) == 2
    said = capsys.readouterr().err
    assert "Typo" in said and "TankFilling" in said
    assert {file.name: file.read_bytes() for file in shipped.iterdir()} == before


def test_what_is_not_there_is_not_named_and_what_is_not_named_goes(shipped: Path) -> None:
    shipped_models.main(["Isotonic", "TankFilling"])
    (shipped / "Isotonic.xz").unlink()
    (shipped / "Former.xz").touch()
    shipped_models.main(["VerticalLoad"])
    assert set(found(shipped)) == {"TankFilling", "VerticalLoad"}
    assert archives(shipped) == {"TankFilling.xz", "VerticalLoad.xz"}
