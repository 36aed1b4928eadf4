"""The valid data set on disk, with one thing changed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.measurement.bench import EXPERIMENT, RUN_01, RUN_02


@pytest.fixture
def make(tmp_path: Path) -> Callable[..., Path]:
    """Writes the valid data set with replacements ``(file, old, new)``, each of which must occur."""

    def write(*changes: tuple[str, str, str]) -> Path:
        texts = {"experiment.toml": EXPERIMENT, "run-01.csv": RUN_01, "run-02.csv": RUN_02}
        for file, old, new in changes:
            assert old in texts[file], f"{old!r} is not in {file}"
            texts[file] = texts[file].replace(old, new, 1)
        folder = tmp_path / "data"
        folder.mkdir()
        for file, text in texts.items():
            (folder / file).write_text(text, encoding="utf-8")
        return folder

    return write
