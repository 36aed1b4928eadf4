"""What tests of reports share."""

from __future__ import annotations

from typing import IO

import pytest
from matplotlib.figure import Figure


@pytest.fixture
def without_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """Figures are made and not drawn, which takes most of a page's time: for tests of the words beside them."""

    def empty(self: Figure, file: IO[bytes], **options: object) -> None:
        file.write(b'<svg xmlns="http://www.w3.org/2000/svg"/>')

    monkeypatch.setattr(Figure, "savefig", empty)
