"""The numbers that decide, as a page of the documentation: ``python -m pam_cosim.reporting.criteria_page FILE``."""

from __future__ import annotations

import sys
from dataclasses import fields
from pathlib import Path

from pam_cosim.criteria import CRITERIA
from pam_cosim.files import write_text

_HEAD = """\
# Every number that decides

These {count} numbers decide which effect a diagnosis names. They are the constants of `pam_cosim/criteria.py`, from
which this page is made (`python -m pam_cosim.reporting.criteria_page docs/criteria.md`). *Chosen* means that neither
theory nor a measurement fixes the number; *blind score* that cases of the [blind score](hidden-effects/report.md)
showed which value serves. Excess is the mean square of residuals beyond the noise; sd are standard deviations.

Numbers that draft a data set, describe a missing term, plan an experiment or draw are constants of the module that uses
them, with a comment.
"""


def criteria_table() -> dict[str, tuple[str, ...]]:
    """The text of the value, the unit, the reason and the source of each criterion, by "group.name"."""
    table = {}
    for group in fields(CRITERIA):
        for criterion in fields(type(members := getattr(CRITERIA, group.name))):
            value = getattr(members, criterion.name)
            values = value if isinstance(value, tuple) else (value,)
            text = ", ".join(f"{v:g}" for v in values)
            table[f"{group.name}.{criterion.name}"] = (text, *criterion.metadata.values())
    return table


def criteria_page() -> str:
    """The page as Markdown."""
    table = criteria_table()
    parts = [_HEAD.format(count=len(table))]
    for group in fields(CRITERIA):
        title = (type(getattr(CRITERIA, group.name)).__doc__ or "").rstrip(".")
        parts.append(f"## {title}\n\n| | value | unit | reason | source |\n|---|---|---|---|---|")
        rows = [_row(name, *c) for name, c in table.items() if name.startswith(f"{group.name}.")]
        parts.append("\n".join(rows) + "\n")
    return "\n".join(parts)


def _row(name: str, value: str, unit: str, reason: str, source: str) -> str:
    unit = "" if unit == "1" else unit
    return f'| <a id="{name}"></a>`{name}` | {value} | {unit} | {reason} | {source} |'


if __name__ == "__main__":
    write_text(Path(sys.argv[1]), criteria_page())
