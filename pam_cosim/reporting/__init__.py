"""Any product -> HTML, PNG."""

from pam_cosim.reporting.comparison_page import comparison_report
from pam_cosim.reporting.diagnosis_page import diagnosis_report
from pam_cosim.reporting.live import Live
from pam_cosim.reporting.plots import draw, error_ladder_figure, plot_comparison, plot_fit, plot_tables, plot_trajectory
from pam_cosim.reporting.printed import diagnosis_text
from pam_cosim.reporting.writing import write_report

__all__ = [
    "Live",
    "comparison_report",
    "diagnosis_report",
    "diagnosis_text",
    "draw",
    "error_ladder_figure",
    "plot_comparison",
    "plot_fit",
    "plot_tables",
    "plot_trajectory",
    "write_report",
]
