"""Cases that were made beforehand are the same ones."""

import json
from pathlib import Path

import pytest

from blind_cases import prepared


def _files(folder: Path) -> dict[str, bytes]:
    return {
        str(f.relative_to(folder)): f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()
    }


@pytest.mark.full
def test_a_prepared_case_is_the_one_that_would_be_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(prepared, "FOLDER", tmp_path / "cases")
    made = prepared.made_case("tuning2", 5, tmp_path / "made")
    prepared.prepare("tuning2", 5)
    assert prepared.made_case("tuning2", 5, tmp_path / "copied") == json.loads(json.dumps(made))
    assert _files(tmp_path / "copied") == _files(tmp_path / "made")
    assert not any("description" in name for name in _files(tmp_path / "copied"))
