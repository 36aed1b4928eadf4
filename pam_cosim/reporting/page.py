"""Templates to one self-contained page."""

from __future__ import annotations

import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version

from jinja2 import Environment, PackageLoader, StrictUndefined

from pam_cosim.comparison import Comparison, SignalScore
from pam_cosim.measurement import ROLES, DataSet
from pam_cosim.reporting.account.wording import NOTHING, number, quantity_text

_LIBRARIES = ("fmpy", "numpy", "scipy", "matplotlib")


@cache
def _environment() -> Environment:
    return Environment(
        loader=PackageLoader("pam_cosim.reporting"),
        autoescape=True,  # titles, names and messages come from users
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=StrictUndefined,
    )


def render(template: str, **content: object) -> str:
    """A page; every text in ``content`` is escaped."""
    return _environment().get_template(template).render(content)


def installed(name: str) -> str:
    """Version of an installed distribution."""
    try:
        return version(name)
    except PackageNotFoundError:
        return "run from its sources, not installed"


def provenance(data: DataSet, model: str) -> list[tuple[str, str]]:
    """What a reader needs to get the same report again."""
    libraries = ", ".join(f"{name} {installed(name)}" for name in _LIBRARIES)
    return [
        ("pam-cosim", installed("pam-cosim")),
        ("model", model),
        ("data set", f"{data.title} (folder {data.folder.name or NOTHING})"),
        ("bench", data.model),
        ("samples", str(sum(run.sample_count(s) for run in data.runs for s in data.signals))),
        ("Python", f"{platform.python_version()}; {libraries}"),
    ]


def signal_rows(data: DataSet) -> list[dict[str, str]]:
    """The measured signals with their noise."""
    rows = []
    for name, signal in data.signals.items():
        counts = {
            role: sum(r.sample_count(name) for r in data.runs if r.role == role) for role in ROLES
        }
        rows.append(
            {
                "name": name,
                "noise": quantity_text(signal.sigma, signal.unit),
                "source": signal.source,
                "use": "fitted" if signal.fitted else "compared, not fitted",
                "fit": str(counts["fit"]),
                "holdout": str(counts["holdout"]),
            }
        )
    return rows


def score_rows(comparison: Comparison) -> list[dict[str, str]]:
    """Every score of every signal, by role."""
    rows = []
    for role in ROLES:
        for name, s in comparison.scores[role].items():
            unit = comparison.data.signals[name].unit
            rows.append(
                {
                    "role": role,
                    "name": name
                    if comparison.data.signals[name].fitted
                    else f"{name} (not fitted)",
                    "rmse": quantity_text(s.rmse, unit),
                    "noise": quantity_text(s.noise_rmse, unit),
                    "range": number(100 * s.nrmse),
                    "bias": quantity_text(s.bias, unit),
                    "max": quantity_text(s.max, unit),
                    "at": _place(comparison, s),
                    "correlation": number(s.correlation, 4),
                    "chi2": number(s.chi2_reduced),
                    "samples": str(s.samples),
                }
            )
    return rows


def _place(comparison: Comparison, s: SignalScore) -> str:
    """Where a signal is furthest off."""
    along = next((r.run.along for r in comparison.runs if r.run.name == s.max_run), None)
    at = (
        f"{number(s.max_time)} s"
        if along is None
        else f"{along.name} = {quantity_text(s.max_time, along.unit)}"
    )
    return f"{at} in {s.max_run}"
