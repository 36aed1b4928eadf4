"""Where the browser is that the tests drive, and what to do where there is none."""

from __future__ import annotations

import os
import shutil

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
MISSING = (
    "NO BROWSER: the tests of the workbench's page are skipped. They drive a Chromium that is installed: "
    "'apt-get install chromium' (Debian), or set PAM_COSIM_CHROMIUM to one."
)


def chromium() -> str | None:
    """The program, or None."""
    named = os.environ.get("PAM_COSIM_CHROMIUM")
    return named or next((path for path in map(shutil.which, NAMES) if path), None)
