"""The numbers that decide, as a page of the documentation: ``python -m pam_cosim.reporting.criteria_page FILE``."""

from __future__ import annotations

import sys
from itertools import groupby
from pathlib import Path

from pam_cosim.criteria import VERDICT, Criteria, Criterion, every_criterion
from pam_cosim.files import write_text

_HEAD = """\
# Every number that decides

What a study says depends on these numbers. They stand in `pam_cosim/criteria.py`, from which this page is made
(`python -m pam_cosim.reporting.criteria_page docs/criteria.md`). *Chosen* means that neither theory nor a measurement
fixes the number; *blind score* that cases of the [blind score](hidden-effects/report.md) showed which value serves.
Excess is the mean square of residuals beyond the noise; sd are standard deviations.

Which effect is said to be missing depends on {deciding} of the {all} numbers, those under
{groups}.
The others draft data sets, and describe, plan and draw.
"""


def criteria_page() -> str:
    """The page as Markdown."""
    every = list(every_criterion())
    deciding = [c for c in every if c.group in VERDICT]
    groups = ", ".join(f"`{name}`" for name in VERDICT)
    parts = [_HEAD.format(deciding=len(deciding), all=len(every), groups=groups)]
    for group, members in groupby(every, key=lambda c: c.group):
        title = (type(getattr(Criteria(), group)).__doc__ or "").rstrip(".")
        parts.append(f"## {title}\n\n| | value | unit | reason | source |\n|---|---|---|---|---|")
        parts.append("\n".join(map(_row, members)) + "\n")
    return "\n".join(parts)


def _row(c: Criterion) -> str:
    unit = "" if c.unit == "1" else c.unit
    return f'| <a id="{c.name}"></a>`{c.name}` | {c.text} | {unit} | {c.reason} | {c.source} |'


if __name__ == "__main__":
    write_text(Path(sys.argv[1]), criteria_page())
