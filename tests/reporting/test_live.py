"""What goes on is drawn in a notebook, and printed elsewhere."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import pam_cosim as pam
from pam_cosim.diagnosis import BaseFitted, CandidateTried, Judged
from pam_cosim.fitting import FitProgress
from pam_cosim.reporting import Live
from pam_cosim.reporting import live as room
from pam_cosim.reporting.live import Tried
from tests.reporting.synthetic import make_diagnosis

STANDING = FitProgress(3, 1.5, {"p": 500.0}, {"p": "Pa"})


def test_it_is_printed_elsewhere(capsys: pytest.CaptureFixture[str]) -> None:
    diagnosis = make_diagnosis("identified")
    tell = pam.live()
    for event in (STANDING, CandidateTried(diagnosis.candidates[0])):
        tell(event)
    tell(Judged(diagnosis.verdict, diagnosis.base, diagnosis.candidates, diagnosis.path))
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "3 simulations, p off by 0.5 kPa rms, chi2 1.5"
    assert lines[1].startswith("  ") and len(lines) == 2


def test_ranking_and_verdict_are_drawn_as_text(monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    monkeypatch.setattr(room, "in_notebook", lambda: True)
    monkeypatch.setattr(Live, "_show", lambda self: drawn.append(self.html()))
    diagnosis, tell = make_diagnosis("identified"), Live()
    tell(BaseFitted(diagnosis.base))
    for c in diagnosis.candidates:
        tell(CandidateTried(c))
    evil = replace(diagnosis.verdict, at_bound=("<script>alert(1)</script>",))
    tell(Judged(evil, diagnosis.base, diagnosis.candidates, diagnosis.path))
    assert "base model refitted" in drawn[0]
    assert drawn[-1].count("<tr>") == 1 + len(diagnosis.candidates) and "Identified" in drawn[-1]
    assert "<script>" not in drawn[-1] and "&lt;script&gt;" in drawn[-1]


def test_the_answer_leads_and_effects_added_to_no_avail_are_not_listed() -> None:
    diagnosis, tried = make_diagnosis("identified"), Tried()
    (answer,) = diagnosis.path
    idle = replace(answer, effects=(*answer.effects, "Idle"), effect="Idle")
    idle = replace(idle, delta_bic=answer.delta_bic - 1.0)
    useful = replace(idle, effects=(*answer.effects, "Useful"), delta_bic=answer.delta_bic - 500.0)
    tried.take(BaseFitted(diagnosis.base))
    every = (useful, idle, *diagnosis.candidates)
    tried.take(Judged(diagnosis.verdict, diagnosis.base, every, diagnosis.path))
    shown = [c.effects for c in tried.telling()]
    assert shown[0] == answer.effects and useful.effects in shown and idle.effects not in shown
    assert len(repr(Judged(diagnosis.verdict, diagnosis.base, every, diagnosis.path))) < 200
    assert len(repr(BaseFitted(diagnosis.base))) < 200


@pytest.mark.full
def test_a_notebook_draws_it(tmp_path: Path) -> None:
    code = (
        "import pam_cosim as pam\nfrom pam_cosim.fitting import FitProgress\ntell = pam.live()\n"
        "for i in range(3):\n    tell(FitProgress(i, 1.5, {'p': 500.0}, {'p': 'Pa'}))\n    import time; time.sleep(0.4)"
    )
    import nbformat
    from nbclient import NotebookClient

    book: Any = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    NotebookClient(book, timeout=120).execute(cwd=str(tmp_path))
    (output,) = book.cells[0].outputs
    assert "2 simulations, p off by 0.5 kPa rms" in output["data"]["text/html"]
