"""What a page offers to download, made when it is requested."""

from __future__ import annotations

from pam_cosim.errors import InputError
from pam_cosim.study.tables import next_run_text
from pam_cosim.workbench.script import python_of
from pam_cosim.workbench.session import Session

NAMES = {
    "next.csv": "text/csv",
    "script.py": "text/x-python",
    "report.html": "text/html",
}


def document(session: Session, name: str) -> str:
    """The text of one of ``NAMES``. It reads the session's state as it is, and may run in any thread.

    Raises:
        InputError: there is nothing of the kind.
    """
    diagnosis = session.state.diagnosis
    if name == "script.py":
        return python_of(session.state, session.first.model, session.folder, session.catalogue)
    if name == "report.html":
        from pam_cosim.reporting import (
            comparison_report,
            diagnosis_report,
        )  # half a second for pictures

        return (
            comparison_report(session.comparison)
            if diagnosis is None
            else diagnosis_report(diagnosis)
        )
    if diagnosis is not None and diagnosis.next_experiment is not None:
        return next_run_text(diagnosis.next_experiment)
    raise InputError(f"there is no {name}: the last diagnosis, if there was one, has none")
