"""The numbers that decide, as a page of the documentation: ``python -m pam_cosim.reporting.criteria_page FILE``."""

from __future__ import annotations

import ast
import sys
from inspect import getsource
from pathlib import Path

from pam_cosim.criteria import CRITERIA
from pam_cosim.files import write_text

_HEAD = """\
# Every number that decides

These {count} numbers decide which effect a diagnosis names. They are the constants of `pam_cosim/criteria.py`, from
which this page is made (`python -m pam_cosim.reporting.criteria_page docs/criteria.md`). *Chosen* means that neither
theory nor a measurement fixes the number; *blind score* that cases of the
[blind score](results.md#hidden-effects-blind) showed which value serves. Excess is the mean square of residuals beyond
the noise; sd are standard deviations.

Numbers that draft a data set, describe a missing term, plan an experiment or draw are constants of the module that uses
them, with a comment.
"""


def criteria_table() -> dict[str, tuple[str, ...]]:
    """The value, the unit, the reason and the source of each criterion as text, by "group.name".

    The last three stand below the number in the source: unit | reason | source, or unit | reason.
    """
    table = {}
    for group, members in vars(CRITERIA).items():
        (definition,) = ast.parse(getsource(type(members))).body
        texts = [
            ast.literal_eval(node.value)
            for node in ast.walk(definition)
            if isinstance(node, ast.Expr)
        ]
        for (name, value), text in zip(vars(members).items(), texts[1:], strict=True):
            values = value if isinstance(value, tuple) else (value,)
            unit, reason, *source = " ".join(text.split()).split(" | ")
            written = ", ".join(f"{v:g}" for v in values)
            table[f"{group}.{name}"] = (written, unit, reason, *(source or ["chosen"]))
    return table


def criteria_page() -> str:
    """The page as Markdown."""
    table = criteria_table()
    parts = [_HEAD.format(count=len(table))]
    for group, members in vars(CRITERIA).items():
        title = (members.__doc__ or "").rstrip(".")
        parts.append(f"## {title}\n\n| | value | unit | reason | source |\n|---|---|---|---|---|")
        rows = [
            f'| <a id="{name}"></a>`{name}` | {" | ".join(texts)} |'
            for name, texts in table.items()
            if name.startswith(f"{group}.")
        ]
        parts.append("\n".join(rows) + "\n")
    return "\n".join(parts)


if __name__ == "__main__":
    write_text(Path(sys.argv[1]), criteria_page())
