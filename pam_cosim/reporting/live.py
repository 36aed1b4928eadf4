"""The progress of a fit or a diagnosis, drawn in a notebook; elsewhere it is printed."""

from __future__ import annotations

import sys
import time
from html import escape
from importlib import import_module
from typing import Any

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import (
    BaseFitted,
    Candidate,
    CandidateTried,
    EffectProbed,
    Event,
    FailedTrial,
    Judged,
)
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.judgement.verdict_sentences import (
    kind_name,
    probability_sentence,
    table_lines,
)
from pam_cosim.fitting import Fit, FitProgress
from pam_cosim.reporting.account.diagnosis_rows import candidate_row

_PACE = 0.3  # [s] between two drawings
_MOST_ROWS = 10
_COLUMNS = {
    "effect": "effect",
    "family": "family",
    "explained": "explained",
    "delta_bic": "ΔBIC",
    "holdout": "held-out χ²",
}


class Tried:
    """The models of a running diagnosis, from its events."""

    def __init__(self) -> None:
        self.base: Fit | None = None
        self.judged: Judged | None = None
        self.failed: list[FailedTrial] = []
        self._tried: dict[tuple[str, ...], Candidate] = {}

    def take(self, event: object) -> None:
        """Takes an event; a whole fit takes the place of the first steps of one."""
        match event:
            case BaseFitted():
                self.base = event.fit
            case CandidateTried(attempt=FailedTrial() as failed):
                self.failed.append(failed)
            case CandidateTried(attempt=Candidate() as made):
                before = self._tried.get(made.effects)
                if before is None or before.brief or not made.brief:
                    self._tried[made.effects] = made
            case Judged():
                self.judged, self.base = event, event.base

    @property
    def path(self) -> tuple[Candidate, ...]:
        """What was added in the end."""
        return self.judged.path if self.judged else ()

    def ranked(self) -> list[Candidate]:
        """The models, best first."""
        if self.judged is not None:
            return list(self.judged.candidates)
        return [] if self.base is None else rank(self.base, list(self._tried.values()))

    def telling(self) -> list[Candidate]:
        """The same, the answer first, without those that add an effect to a better or equal model to no avail."""
        ranked = [*reversed(self.path), *self.ranked()]
        candidates_by_effects: dict[tuple[str, ...], Candidate] = {}
        for c in ranked:
            most = c.delta_bic + CRITERIA.evidence.very_strong
            idle = any({*o.effects} < {*c.effects} and o.delta_bic < most for o in ranked)
            if c in self.path or not idle:
                candidates_by_effects.setdefault(c.effects, c)
        return list(candidates_by_effects.values())


class Live:
    """A receiver of progress: ``pam.fit(data, progress=pam.live())``, ``pam.diagnose(data, progress=pam.live())``.

    In a notebook one picture of how things stand, the errors of a fit, the ranking and the verdict of a diagnosis, is
    drawn again as they change. Elsewhere every line is printed.
    """

    def __init__(self) -> None:
        self._handle: Any = None
        self._drawn = 0.0
        self._line, self._headline = "", ""
        self._tried = Tried()

    def __call__(self, event: FitProgress | Event) -> None:
        """Takes a ``FitProgress`` of a fit, or an event of a diagnosis."""
        if not in_notebook():
            if str(event):
                print(event.message if isinstance(event, Event) else event, flush=True)
            return
        self._take(event)
        if isinstance(event, Judged) or time.monotonic() - self._drawn >= _PACE:
            self._drawn = time.monotonic()
            self._show()

    def _take(self, event: FitProgress | Event) -> None:
        self._line = event.status if isinstance(event, EffectProbed) else str(event) or self._line
        if isinstance(event, Event) and str(event) and not event.detail:
            self._headline = str(event)
        self._tried.take(event)

    def html(self) -> str:
        """How things stand."""
        parts = [f"<p>{escape(self._headline)}</p>"] if self._headline else []
        parts.append(f"<p>{escape(self._line)}</p>" * (self._line != self._headline))
        if self._tried.base is not None and self._tried.ranked():
            parts.append(self._table(self._tried.base))
        if self._tried.judged is not None:
            verdict = self._tried.judged.verdict
            text = f"{kind_name(verdict.kind)}. {verdict.reason} {probability_sentence(verdict)}"
            parts.append(f"<p><strong>{escape(text.strip())}</strong></p>")
            parts += [f"<pre>{escape(line)}</pre>" for line in table_lines(verdict)]
        return "".join(parts)

    def _table(self, base: Fit) -> str:
        rows = [
            candidate_row(base, c, self._tried.path) for c in self._tried.telling()[:_MOST_ROWS]
        ]
        head = "".join(f"<th>{escape(title)}</th>" for title in _COLUMNS.values())
        body = "".join(
            "<tr>" + "".join(f"<td>{escape(str(row[key]))}</td>" for key in _COLUMNS) + "</tr>"
            for row in rows
        )
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"

    def _show(self) -> None:
        picture = {"text/html": self.html()}
        if self._handle is None:
            notebook: Any = import_module("IPython.display")
            self._handle = notebook.display(picture, raw=True, display_id=True)
        else:
            self._handle.update(picture, raw=True)


def in_notebook() -> bool:
    """Whether a kernel draws what is displayed."""
    kernel = sys.modules.get("IPython")
    shell = kernel.get_ipython() if kernel is not None else None
    return shell is not None and hasattr(shell, "kernel")
