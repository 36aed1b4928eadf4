"""Any product -> HTML, PNG, SVG, PDF. Its sentences, without a picture, are in ``pam_cosim.reporting.account``."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pam_cosim.reporting.account.printed import diagnosis_text
    from pam_cosim.reporting.comparison_page import comparison_report
    from pam_cosim.reporting.diagnosis_page import diagnosis_report
    from pam_cosim.reporting.live import Live
    from pam_cosim.reporting.plots import draw, plot_fit, plot_tables
    from pam_cosim.reporting.writing import write_report

__all__ = [
    "Live",
    "comparison_report",
    "diagnosis_report",
    "diagnosis_text",
    "draw",
    "plot_fit",
    "plot_tables",
    "write_report",
]

if not TYPE_CHECKING:
    _ROOMS = ("account.printed", "writing", "live", "comparison_page", "diagnosis_page", "plots")

    def __getattr__(name: str) -> object:
        """Loads names on first use: pictures take half a second, and words need none."""
        if name in __all__:
            for room in _ROOMS:
                module = import_module(f"{__name__}.{room}")
                if hasattr(module, name):
                    return getattr(module, name)
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
