"""One study that a person works on: what is done to it, in one thread, and who is told. There is no web in it."""

from __future__ import annotations

import inspect
import shutil
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from pam_cosim.catalogue import qualified
from pam_cosim.comparison import Comparison, RunComparison, samples_in, scored, where
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import Estimate
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.commands import COMMANDS
from pam_cosim.workbench.curves import measured_curves, model_curves
from pam_cosim.workbench.frames import frame
from pam_cosim.workbench.job_process import Worker
from pam_cosim.workbench.job_queue import JobQueue, failed_by
from pam_cosim.workbench.opened_model import Opened, open_model
from pam_cosim.workbench.protocol import Json, StudyEvent
from pam_cosim.workbench.saving import FILE as SAVED
from pam_cosim.workbench.saving import lean_fit, load_state
from pam_cosim.workbench.simulators import Simulated
from pam_cosim.workbench.source import MeasurementSource
from pam_cosim.workbench.starts import StartsShown, courses
from pam_cosim.workbench.state import State, standing_label, with_rung
from pam_cosim.workbench.state_events import (
    rung_of,
    scores_event,
    short_name,
    steps_event,
    study_event,
    where_event,
)
from pam_cosim.workbench.steps import Step
from pam_cosim.workbench.windows import Listener, Windows

QUIET = 0.3  # [s] without a new value after which it is said where the error sits
MOST_BACK = 100  # steps that can be taken back


class Session:
    """A study with its windows.

    Every command runs in one thread, in the order in which they came; values that are set while others are being drawn
    wait as one, so that dragging a slider never makes a queue. What takes long runs in a process of its own.

    Args:
        folder: of the data set.
        model: default: the bench of the data set.
        files: further Modelica files.
        windows: that look at it; default: none yet.
        workers: number of processes of a diagnosis, as for ``study.diagnose``.
        worker: the process in which it fits, if there is one already; the session ends it.

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
    ) -> None:
        self.folder, self.files = Path(folder), tuple(Path(f) for f in files)
        self.source = MeasurementSource(self.folder, self.files)
        self.windows, self.catalogue = windows or Windows(), Catalogue(self.files)
        self.worker, self.workers = worker or Worker(), workers
        self.work = JobQueue(self)
        self.scratch = Path(tempfile.mkdtemp(prefix="pam-cosim-workbench-"))
        self.past: list[State] = []
        self.saved: tuple[Step, ...] | None = None
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="study")
        self._lock = threading.Lock()
        self._wanted: Json = {}
        self._version = 0
        self._looking = False
        self._open: Opened | None = None
        self._comparison: Comparison | None = None
        self._begun: dict[str, Estimate] = {}
        self._starts = StartsShown()
        try:
            self._thread.submit(self._begin, model).result()
        except BaseException:
            self.close()
            raise

    def _begin(self, model: str | None) -> None:
        data = self.source.read(model)
        self.benches = self.catalogue.benches(data.model)
        self.first = self.state = State(data, data.model_for(model))
        self._install(self.state)
        self._take_saved(named=model is not None)

    def _take_saved(self, named: bool) -> None:
        """Goes on where the study was saved, if it was; what is wrong with that is told.

        Where a model was named, a study of another one is left for the person to load.
        """
        if not (self.folder / SAVED).is_file():
            return
        try:
            if named:
                self._check_is_of_first(load_state(self.folder, self.first).model)
            COMMANDS["load"](self)
        except (InputError, SimulationFailure) as problem:
            self.windows.send(failed_by(problem, "load").message(), every=True)

    def _check_is_of_first(self, model: str) -> None:
        if not self.is_first(model):
            raise InputError(
                f"the saved study is of {short_name(model)}, and was not loaded: this one was opened with "
                f"{short_name(self.first.model)}; 'Load what was saved' under Study goes on with it"
            )

    def is_first(self, model: str) -> bool:
        """Whether it is the model with which the study was opened, however it is written."""
        first, tree = self.first, self.catalogue.tree(self.first.model)
        asked = first.data.unmapped or first.model
        return model == first.model or qualified(tree, model) == qualified(tree, asked)

    def close(self) -> None:
        """Ends everything; nothing is saved by it."""
        self._thread.shutdown(wait=True, cancel_futures=True)
        self.worker.end()
        if self._open is not None:
            self._open.close()
            self._open = None
        shutil.rmtree(self.scratch, ignore_errors=True)

    def prepare(self) -> None:
        """Lets the process in which it fits be ready before anybody asks for a fit."""
        opened = self.opened
        content = (self.state.data, opened.name, {"files": opened.files})
        self.worker.run(
            "prepare", *content, heard=lambda said: None, done=lambda well, result: None
        )

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *problem: object) -> None:
        self.close()

    # what the commands use

    @property
    def opened(self) -> Opened:
        """The standing model, ready to run."""
        assert self._open is not None
        return self._open

    @property
    def comparison(self) -> Comparison:
        """The standing model against the measurement."""
        assert self._comparison is not None
        return self._comparison

    @property
    def version(self) -> int:
        """Number of what was drawn last."""
        return self._version

    def submit(self, method: Callable[..., None], *arguments: Any) -> None:
        """Does something in the study's thread, if there still is one."""
        with suppress(RuntimeError):
            self._thread.submit(self._guarded, method, *arguments)

    def _guarded(self, method: Callable[..., None], *arguments: Any) -> None:
        try:
            method(*arguments)
        except Exception as problem:  # there is no command that it could be answered to
            self.work.failed(problem)

    def later(self, seconds: float, method: Callable[..., None], *arguments: Any) -> None:
        """Does something in the study's thread after some time."""
        timer = threading.Timer(seconds, self.submit, (method, *arguments))
        timer.daemon = True
        timer.start()

    def enter(self, state: State) -> None:
        """Makes a state the present one, a step after the one before: all that depends on it is made anew, or nothing.

        Raises:
            InputError: there is no such model.
            SimulationFailure: a run cannot be simulated.
        """
        before, standing = self.state, self.comparison
        if before.milestone:
            state = replace(
                state, rungs=with_rung(state.rungs, rung_of(before.milestone, standing))
            )
        self._install(state)
        if len(state.steps) > len(before.steps) or not self.past:
            self.remember(before)

    def remember(self, state: State) -> None:
        """Keeps a state to go back to, without the curves of its fit, which are many."""
        kept = state if state.fit is None else replace(state, fit=lean_fit(state.fit))
        self.past = [*self.past[-MOST_BACK:], kept]

    def back(self, state: State) -> None:
        """Makes a state the present one that stood before, or that was loaded."""
        self._install(state)

    def _install(self, state: State) -> None:
        old = self._open
        same = old is not None and old.is_of(state.data, state.model, state.effects)
        fresh = (
            old
            if same
            else open_model(state.data, state.model, state.effects, self.catalogue, self.scratch)
        )
        assert fresh is not None
        try:
            runs, begun = self._simulated(state, fresh)
            comparison = self._scored(state, fresh, runs)
        except BaseException:
            if not same:
                fresh.close()
            raise
        if old is not None and not same:
            old.close()
        if self._comparison is None or state.data is not self.state.data:
            curves = measured_curves(self.source.whole(state.data))
            self.windows.send(frame("measured", self._version, curves), "measured")
        if not same or state.data is not self.state.data:
            self._starts.forget()
        self.state, self._open, self._comparison, self._begun = state, fresh, comparison, begun
        self.draw()
        self.tell_study()

    def move(self, state: State) -> None:
        """As ``enter`` where only values are set: the curves are drawn before anything else is reckoned."""
        before, standing = self.state, self.comparison
        runs, begun = self._simulated(state, self.opened)
        self._version += 1
        self._draw(state, runs)
        if before.milestone:
            state = replace(
                state, rungs=with_rung(state.rungs, rung_of(before.milestone, standing))
            )
        if len(state.steps) > len(before.steps):
            self.remember(before)
        self.state, self._comparison, self._begun = (
            state,
            self._scored(state, self.opened, runs),
            begun,
        )
        self._tell_scores()

    def draw(self) -> None:
        """Draws the standing model."""
        self._version += 1
        self._draw(self.state, self.comparison.runs)
        self._tell_scores()

    def draw_passing(self, values: Mapping[str, float]) -> None:
        """Draws the standing model at other values, without making them those of the study."""
        passing = replace(self.state, values=values, milestone="")
        runs, _ = self._simulated(passing, self.opened)
        self._version += 1
        self._draw(passing, runs)
        comparison = self._scored(passing, self.opened, runs)
        self.windows.tell(scores_event(passing, self.opened, comparison, self._version))

    def start_values_of(self, run: str) -> dict[str, float]:
        """Where a run begins, by "state@run" [SI].

        Raises:
            InputError: there is no such run, or what was before its first sample says where it begins.
        """
        known = {one.name: one for one in self.state.data.runs if not one.is_static}
        if run not in known:
            raise InputError(f"there is no recording {shown(run)}; {did_you_mean(run, known)}")
        found = courses(known[run], self.state, self.opened, self._begun, only_start=True)
        if not found:
            raise InputError(
                f"{run} begins as what was before its first sample says: choose how it begins first"
            )
        return {f"{name}@{run}": float(values[0]) for name, values in found.items()}

    def _simulated(self, state: State, opened: Opened) -> Simulated:
        return opened.simulators.run(state.data, state.values)

    def _scored(self, state: State, opened: Opened, runs: Sequence[RunComparison]) -> Comparison:
        """The same as ``study.compare`` finds, but for where the error sits."""
        return scored(opened.simulator.interface, state.data, state.values, runs, rules=False)

    def _draw(self, state: State, runs: Sequence[RunComparison]) -> None:
        label = standing_label(state)
        self.windows.send(
            frame("model", self._version, model_curves(runs, self.source.whole(state.data)), label),
            "model",
        )

    def _tell_scores(self) -> None:
        self.windows.tell(scores_event(self.state, self.opened, self.comparison, self._version))
        self.tell_steps()
        if not self._looking:
            self._looking = True
            self.later(QUIET, self._tell_where, self._version)

    def tell_steps(self) -> None:
        """Tells what was done."""
        self.windows.tell(steps_event(self.state, self.is_saved))

    def tell_study(self) -> None:
        """Tells all that moves seldom."""
        self.windows.tell(self._study())
        self.tell_starts()
        self._tell_reference()

    def _tell_reference(self) -> None:
        """Tells the curves from before the last change of effects, or that there are none any more."""
        before = self.state.before
        if before is not None:
            curves = model_curves(before.runs, self.source.whole(self.state.data))
            self.windows.send(frame("reference", self._version, curves, "before"), "reference")
        elif self.windows.forget_frame("reference"):
            self.windows.send(frame("reference", self._version, []))

    def tell_starts(self) -> None:
        """Tells where runs begin."""
        self.windows.tell(self._starts.event(self.state, self.opened, self._begun, self._version))

    def _study(self) -> StudyEvent:
        state = self.state
        return study_event(
            state, self.opened, self.catalogue.shown(state.model, state.effects), self.benches
        )

    def subscribe(self, listener: Listener) -> Future[Callable[[], None]]:
        """Adds a window, which is told all that there is; what the future holds takes it away.

        The listener is called from other threads and must not wait.
        """

        def begin() -> Callable[[], None]:
            self.windows.keep(self._study())
            return self.windows.subscribe(listener)

        return self._thread.submit(begin)

    def _tell_where(self, version: int) -> None:
        """Says where the error sits, as soon as nothing newer has been drawn for a while."""
        if version != self._version or self._wanted:
            self.later(QUIET, self._tell_where, self._version)
            return
        self._looking = False
        self.tell_starts()
        interface, data = self.opened.simulator.interface, self.state.data
        about = (
            self.comparison.runs,
            data.signals,
            interface.outputs,
            data.domain,
            interface.inputs,
        )
        rules = where(*about)
        self.windows.tell(where_event(rules, [samples_in(rule, *about) for rule in rules], version))

    @property
    def is_saved(self) -> bool:
        """Whether the study has been saved as it is."""
        return self.saved == self.state.steps

    # what a page uses

    def do(self, command: Mapping[str, Any]) -> Future[Json]:
        """Takes a command of a page; the future holds what is answered.

        Its exceptions are ``InputError`` and ``SimulationFailure``.
        """
        name = command.get("do")
        if not isinstance(name, str) or name not in COMMANDS:
            return _refused(
                InputError(
                    f"there is no command {shown(name)}; {did_you_mean(str(name), COMMANDS)}"
                )
            )
        arguments = {str(key): value for key, value in command.items() if key not in ("do", "id")}
        try:
            inspect.signature(COMMANDS[name]).bind(self, **arguments)
        except TypeError as problem:
            return _refused(InputError(f"the command {name} cannot be used: {problem}"))
        if name != "set":
            return self._thread.submit(self._done, name, arguments)
        values = arguments["values"]
        if not isinstance(values, Mapping):
            return _refused(InputError("set wants numbers by name"))
        with self._lock:
            self._wanted |= {str(one): value for one, value in values.items()}
        return self._thread.submit(self._set_wanted)

    def _set_wanted(self) -> Json:
        with self._lock:
            wanted, self._wanted = self._wanted, {}
        return self._done("set", {"values": wanted}) if wanted else {"version": self._version}

    def _done(self, name: str, arguments: Json) -> Json:
        result = COMMANDS[name](self, **arguments)
        return {"version": self._version, **(result or {})}

    def wait(self) -> None:
        """Returns when all commands are done, but for what takes long."""
        self._thread.submit(lambda: None).result()


def _refused(problem: Exception) -> Future[Json]:
    refused: Future[Json] = Future()
    refused.set_exception(problem)
    return refused
