"""What takes long in a study: one job at a time, followed as it goes, held and resumed."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pam_cosim.diagnosis import EffectProbed, Message
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import FitProgress
from pam_cosim.reporting.live import Tried
from pam_cosim.units import readable_factor
from pam_cosim.workbench.diagnosis_events import diagnosis_events, events_of, found_label
from pam_cosim.workbench.job_process import Worker
from pam_cosim.workbench.open_study import OpenStudy
from pam_cosim.workbench.protocol import DIAGNOSIS, Json, event, selected
from pam_cosim.workbench.windows import Windows

_PACE = 0.1  # [s] between two drawings of a running fit
_RANKED = 0.3  # [s] between two rankings of a running diagnosis

_WORDS = {"fit": "a fit", "diagnose": "a diagnosis", "check": "a check"}


@dataclass
class Job:
    """A background job.

    Attributes:
        what: "fit", "diagnose" or "check".
        text: the last headline.
        finish: called with the result, in the study's thread.
        tried: by the diagnosis so far.
        values: of the study when it began [SI]: sliders may be moved while it is stopped.
        began: seconds since the epoch.
    """

    what: str
    text: str
    finish: Callable[[Any], object]
    values: Mapping[str, float]
    tried: Tried = field(default_factory=Tried)
    began: float = field(default_factory=time.time)
    held: bool = False
    drawn: float = 0.0
    ranked: float = 0.0


class StudyWithJobs(OpenStudy):
    """A study, and the job in its background, if there is one. Everything here runs in the study's thread.

    Args:
        folder: of the data set.
        model: default: the bench of the data set.
        files: further Modelica files.
        windows: that show it; default: none yet.
        workers: number of processes of a diagnosis, as for ``study.diagnose``.
        worker: the process in which it fits, if there is one already; it ends with the study.
        complete: as for ``OpenStudy``.

    Raises:
        InputError: the data set cannot be read.
    """

    def __init__(
        self,
        folder: Path,
        *,
        model: str | None = None,
        files: Sequence[Path] = (),
        windows: Windows | None = None,
        workers: int | None = None,
        worker: Worker | None = None,
        complete: bool = False,
    ) -> None:
        self.worker, self.workers = worker or Worker(), workers
        self.job: Job | None = None
        super().__init__(folder, model, files, windows or Windows(), complete)

    def close(self) -> None:
        """Ends everything; nothing is saved by it."""
        super().close()
        self.worker.end()

    def prepare(self) -> None:
        """Lets the process in which it fits be ready before anybody asks for a fit."""
        opened = self.opened
        self.worker.run(
            "prepare",
            self.state.data,
            opened.name,
            {"files": opened.files},
            heard=lambda message: None,
            on_end=lambda well, result: None,
        )

    def check_free(self) -> None:
        """Refuses what cannot be done while a job runs.

        Raises:
            InputError: a job runs.
        """
        if self.job is not None and not self.job.held:
            raise InputError(
                f"{_WORDS[self.job.what]} is running: stop it first, or wait until it is done"
            )

    def make_room(self) -> None:
        """As ``check_free``; a job that was stopped is given up, for it would be of another study."""
        self.check_free()
        if self.job is not None:
            self.discard()

    def begin_job(
        self, kind: str, text: str, options: Mapping[str, Any], finish: Callable[[Any], object]
    ) -> None:
        """Begins a job of the standing model."""
        self.make_room()
        self.windows.forget(lines=True)
        data, opened = self.state.data, self.opened
        self.job = job = Job(kind, text, finish, dict(self.state.values))
        self._tell_busy(job)
        worker_option = {} if kind == "fit" else {"workers": self.workers}
        self.worker.run(
            kind,
            data,
            opened.name,
            {"files": opened.files, **worker_option, **options},
            lambda message: self.submit(self._heard, job, message),
            lambda well, result: self.submit(self._done, job, well, result),
        )

    def _tell_busy(self, job: Job) -> None:
        self.windows.tell(event("busy", **selected(job, "what text began held")))

    def stop(self) -> None:
        """Holds the job where it is; where that cannot be done it is ended.

        Raises:
            InputError: there is nothing to stop.
        """
        if self.job is None or self.job.held:
            raise InputError("no job is running to be stopped")
        if not self.worker.hold():
            self.discard()
            return
        self.job.held = True
        self._tell_busy(self.job)

    def resume(self) -> None:
        """Resumes the job.

        Raises:
            InputError: there is nothing that was stopped.
        """
        if self.job is None or not self.job.held:
            raise InputError("no job is stopped that could continue")
        self.worker.go_on()
        self.job.held = False
        self._tell_busy(self.job)

    def discard(self) -> None:
        """Ends the job for good.

        Raises:
            InputError: there is nothing to end.
        """
        if self.job is None:
            raise InputError("no job is running to be ended")
        self.worker.end()
        self._over(self.job, "stopped")
        self.draw()
        self.prepare()

    def clear_diagnosis(self) -> None:
        """Sends that the events of a diagnosis are no longer those of the study."""
        self.windows.forget(*DIAGNOSIS)
        self.windows.tell(event("no_diagnosis"))
        self.draw_beside("found", None)

    def tell_diagnosis(self) -> None:
        """Sends the verdict of the standing study, or that there is none."""
        state, diagnosis = self.state, self.state.diagnosis
        self.clear_diagnosis()
        for message in [] if diagnosis is None else diagnosis_events(diagnosis):
            self.windows.tell(message)
        if diagnosis and diagnosis.path and len(state.effects) == len(state.diagnosed):
            self.draw_beside("found", diagnosis.final.comparison, found_label(diagnosis))

    def _over(self, job: Job, end: str) -> None:
        self.job = None
        self.windows.forget("busy")
        self.windows.tell(event("idle", what=job.what, end=end, seconds=time.time() - job.began))
        if job.what == "diagnose" and end != "done":  # its ranking is none that could be taken from
            self.tell_diagnosis()

    def _heard(self, job: Job, message: object) -> None:
        if job is not self.job:
            return
        if isinstance(message, FitProgress):
            self._show_progress(job, message)
            return
        happening = message
        if isinstance(message, Message):
            text, happening = str(message), message.event
            kind = "detail" if message.detail else "headline"
            self.windows.tell(event("message", text=text.strip(), kind=kind))
            if not message.detail:
                job.text = text
                self._tell_busy(job)
        if isinstance(happening, EffectProbed):
            job.text = happening.status
            self._tell_busy(job)
        for shown_event in events_of(happening, job.tried, self.state.data.domain):
            if self._is_due(job, shown_event):
                self.windows.tell(shown_event)

    def _is_due(self, job: Job, message: Json) -> bool:
        """Rankings come with every candidate; not all of them need be drawn."""
        if message.get("final", True):
            return True
        if time.monotonic() - job.ranked < _RANKED:
            return False
        job.ranked = time.monotonic()
        return True

    def _show_progress(self, job: Job, progress: FitProgress) -> None:
        parameters = self.opened.parameters
        values = {n: v for n, v in progress.values.items() if n in parameters}
        readable_values = {n: v * readable_factor(parameters[n].unit) for n, v in values.items()}
        self.windows.tell(event("progress", values=readable_values, text=str(progress)))
        if values and time.monotonic() - job.drawn >= _PACE:
            self.draw_passing({**job.values, **values})
            job.drawn = time.monotonic()

    def _done(self, job: Job, well: bool, result: Any) -> None:
        if job is not self.job:
            return
        try:
            if well:
                job.finish(result)
        except (InputError, SimulationFailure) as problem:
            well, result = False, problem
        self._over(job, "done" if well else "failed")
        if not well:
            self.tell_failure(result, job.what)
            self.draw()
