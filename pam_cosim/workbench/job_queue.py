"""What takes long in a session: one thing at a time, followed as it goes, held and let go on."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pam_cosim.diagnosis import EffectProbed, Message
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import FitProgress
from pam_cosim.units import readable_factor
from pam_cosim.workbench.diagnosis_events import Following, diagnosis_events, shown_rms
from pam_cosim.workbench.protocol import (
    BusyEvent,
    FailedEvent,
    IdleEvent,
    LedgerEvent,
    LineEvent,
    NoDiagnosisEvent,
    PageEvent,
    ProgressEvent,
    RankingEvent,
    VerdictEvent,
)

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session

_PACE = 0.1  # [s] between two drawings of a fit that goes on
_RANKED = 0.3  # [s] between two rankings of a diagnosis that goes on

_WORDS = {"fit": "a fit", "diagnose": "a diagnosis", "check": "a check"}


@dataclass
class Job:
    """Something that goes on.

    Attributes:
        what: "fit", "diagnose" or "check".
        text: the last headline.
        began: seconds since the epoch.
        finish: called with the result, in the study's thread.
        values: of the study when it began [SI]: sliders may be moved while it is stopped.
    """

    what: str
    text: str
    finish: Callable[[Any], None]
    following: Following
    values: Mapping[str, float] = field(default_factory=dict)
    began: float = field(default_factory=time.time)
    held: bool = False
    drawn: float = 0.0
    ranked: float = 0.0

    def busy(self) -> BusyEvent:
        """What is told of it."""
        return BusyEvent(self.what, self.text, self.began, self.held)


class JobQueue:
    """The long thing of a session, if there is one. Everything here runs in the study's thread."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.job: Job | None = None

    def check_free(self) -> None:
        """Refuses what cannot be done while something goes on.

        Raises:
            InputError: it does.
        """
        if self.job is not None and not self.job.held:
            raise InputError(
                f"{_WORDS[self.job.what]} is running: stop it first, or wait until it is done"
            )

    def make_room(self) -> None:
        """As ``check_free``; what was stopped is given up, for it would be of another study."""
        self.check_free()
        if self.job is not None:
            self.discard()

    def begin(
        self, what: str, text: str, options: Mapping[str, Any], finish: Callable[[Any], None]
    ) -> None:
        """Begins something, of the standing model."""
        self.make_room()
        session, windows = self.session, self.session.windows
        windows.forget(lines=True)
        self.job = job = Job(
            what, text, finish, Following(session.state.data), dict(session.state.values)
        )
        windows.tell(job.busy())
        opened = session.opened
        further = {} if what == "fit" else {"workers": session.workers}
        session.worker.run(
            what,
            session.state.data,
            opened.name,
            {"files": opened.files, **further, **options},
            lambda said: session.submit(self._heard, job, said),
            lambda well, result: session.submit(self._done, job, well, result),
        )

    def stop(self) -> None:
        """Holds it where it is; where that cannot be done it is ended.

        Raises:
            InputError: there is nothing to stop.
        """
        job = self.job
        if job is None or job.held:
            raise InputError("nothing is running that could be stopped")
        if not self.session.worker.hold():
            self.discard()
            return
        job.held = True
        self.session.windows.tell(job.busy())

    def resume(self) -> None:
        """Lets it go on.

        Raises:
            InputError: there is nothing that was stopped.
        """
        job = self.job
        if job is None or not job.held:
            raise InputError("nothing was stopped that could go on")
        self.session.worker.go_on()
        job.held = False
        self.session.windows.tell(job.busy())

    def discard(self) -> None:
        """Ends it for good.

        Raises:
            InputError: there is nothing to end.
        """
        if self.job is None:
            raise InputError("nothing is running that could be ended")
        self.session.worker.end()
        self._over("stopped")
        self.session.draw()
        self.session.prepare()

    def clear_diagnosis(self) -> None:
        """Tells that what was said of a diagnosis counts no more."""
        self.session.windows.forget(RankingEvent, VerdictEvent, LedgerEvent)
        self.session.windows.tell(NoDiagnosisEvent())

    def tell_diagnosis(self) -> None:
        """Tells the verdict of the standing study, or that there is none."""
        diagnosis = self.session.state.diagnosis
        self.clear_diagnosis()
        for event in [] if diagnosis is None else diagnosis_events(diagnosis):
            self.session.windows.tell(event)

    def failed(self, problem: BaseException, during: str = "") -> None:
        """Tells all windows what went wrong."""
        self.session.windows.tell(failed_by(problem, during))

    def _over(self, end: str) -> None:
        job, self.job = self.job, None
        assert job is not None
        self.session.windows.forget(BusyEvent)
        self.session.windows.tell(IdleEvent(job.what, end, time.time() - job.began))
        if job.what == "diagnose" and end != "done":  # its ranking is none that could be taken from
            self.tell_diagnosis()

    def _heard(self, job: Job, said: object) -> None:
        if job is not self.job:
            return
        if isinstance(said, FitProgress):
            self._stands(job, said)
            return
        windows = self.session.windows
        if isinstance(said, Message):
            windows.tell(LineEvent(str(said).strip(), "detail" if said.detail else "headline"))
            if not said.detail:
                job.text = str(said)
                windows.tell(job.busy())
        event = said.event if isinstance(said, Message) else said
        if isinstance(event, EffectProbed):
            job.text = event.status
            windows.tell(job.busy())
        for told in job.following.events(event):
            if self._worth(job, told):
                windows.tell(told)

    def _worth(self, job: Job, event: PageEvent) -> bool:
        """Rankings come with every candidate; not all of them need be drawn."""
        if not isinstance(event, RankingEvent) or event.final:
            return True
        if time.monotonic() - job.ranked < _RANKED:
            return False
        job.ranked = time.monotonic()
        return True

    def _stands(self, job: Job, standing: FitProgress) -> None:
        session = self.session
        parameters = session.opened.parameters
        values = {n: v for n, v in standing.values.items() if n in parameters}
        shown = {n: v * readable_factor(parameters[n].unit) for n, v in values.items()}
        rms = shown_rms(standing.rmse, session.state.data)
        session.windows.tell(
            ProgressEvent(standing.evaluations, rms, standing.chi2_reduced, shown, str(standing))
        )
        if values and time.monotonic() - job.drawn >= _PACE:
            session.draw_passing({**job.values, **values})
            job.drawn = time.monotonic()

    def _done(self, job: Job, well: bool, result: Any) -> None:
        if job is not self.job:
            return
        if not well:
            self._over("failed")
            self.failed(result, job.what)
            self.session.draw()
            return
        try:
            job.finish(result)
        except (InputError, SimulationFailure) as problem:
            self._over("failed")
            self.failed(problem, job.what)
            return
        self._over("done")


def failed_by(problem: BaseException, during: str = "") -> FailedEvent:
    """What went wrong, in words, and where; of a file its name alone is told."""
    if isinstance(problem, InputError):
        place = "" if problem.file is None else Path(str(problem.file)).name
        column = "" if problem.column is None else str(problem.column)
        return FailedEvent(problem.message, place, problem.line, column, during)
    if isinstance(problem, SimulationFailure):
        return FailedEvent(f"the simulation failed: {problem}", during=during)
    return FailedEvent(
        f"something went wrong that should not ({type(problem).__name__}: {problem})", during=during
    )
