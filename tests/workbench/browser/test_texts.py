"""What files contain is text on the page, never markup; nothing is loaded from outside."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.workbench.browser.conftest import serving

HOSTILE = "<img src=x onerror=alert(1)><script>document.title='taken'</script><b>bold</b>"


@pytest.mark.full
def test_a_title_with_markup_stays_text(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "hostile"
    shutil.copytree(muscle, folder)
    file = folder / "experiment.toml"
    text = file.read_text()
    title = 'title = """' + HOSTILE + '"""'
    file.write_text("\n".join([title, *text.splitlines()[1:]]))
    with serving(folder) as address:
        page = opened(address)
        assert page.locator("#title").inner_text() == HOSTILE
        assert page.locator("#title *").count() == 0
        assert page.locator("img, b img").count() == 0
        assert page.title().startswith(HOSTILE)
        page.close()
