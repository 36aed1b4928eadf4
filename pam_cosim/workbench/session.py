"""One study that a person works on: what is done to it, in one thread, and who is told. There is no web in it."""

from __future__ import annotations

import shutil
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from pam_cosim import study
from pam_cosim.catalogue import effect_classes, origins, qualified
from pam_cosim.catalogue.compose import compose_on
from pam_cosim.comparison import Comparison, compare, sitting, where
from pam_cosim.compiler import read_library, read_structure
from pam_cosim.errors import InputError
from pam_cosim.fitting import Free
from pam_cosim.measurement import complete_noise
from pam_cosim.names import is_fmu, is_modelica
from pam_cosim.settings import value_of as setting_of
from pam_cosim.units import readable_factor
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.catalogue import shown_effect
from pam_cosim.workbench.curves import measured_curves, model_curves
from pam_cosim.workbench.opened import Opened, open_model
from pam_cosim.workbench.protocol import Event, Json, ShownEffect, frame
from pam_cosim.workbench.shown import label_of, scores_event, steps_event, study_event, value_of, where_event
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import SET, Step, with_step

QUIET = 0.2  # [s] without a new value after which it is said where the error sits
Listener = Callable[[str | bytes], None]


class Session:
    """A study with its windows.

    Every command runs in one thread, in the order in which they came; values that are set while others are being drawn
    wait as one, so that dragging a slider never makes a queue.

    Args:
        folder: of the data set.
        model: default: the bench of the data set.
        files: further Modelica files.

    Raises:
        InputError: the data set cannot be read.
    """

    def __init__(self, folder: Path, *, model: str | None = None, files: Sequence[Path] = ()) -> None:
        self.folder, self.files = Path(folder), tuple(Path(f) for f in files)
        self._scratch = Path(tempfile.mkdtemp(prefix="pam-cosim-workbench-"))
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="study")
        self._lock = threading.Lock()
        self._listeners: list[Listener] = []
        self._kept: dict[str, str | bytes] = {}
        self._wanted: dict[str, Any] = {}
        self._drawing: Future[None] | None = None
        self._version = 0
        self._opened: Opened | None = None
        self._comparison: Comparison | None = None
        self._effects: dict[str, tuple[ShownEffect, ...]] = {}
        self._past: list[State] = []
        self._saved = False
        self._benches = tuple(study.benches(self.files))
        try:
            data = complete_noise(study.read(self.folder, model=model, files=self.files))
            self.state = State(data, model or data.model)
            self._thread.submit(self._open).result()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Ends everything; nothing is saved by it."""
        self._thread.shutdown(wait=True, cancel_futures=True)
        if self._opened is not None:
            self._opened.simulator.close()
            self._opened = None
        shutil.rmtree(self._scratch, ignore_errors=True)

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *problem: object) -> None:
        self.close()

    # --- windows

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Tells a new window all that there is, and from now on what happens; returns what ends that.

        The listener is called from other threads and must not wait.
        """
        with self._lock:
            for message in self._kept.values():
                listener(message)
            self._listeners.append(listener)

        def end() -> None:
            with self._lock, suppress(ValueError):
                self._listeners.remove(listener)

        return end

    def _tell(self, event: Event) -> None:
        kept = type(event).__name__ if event.kept else None
        self._send(event.message(), kept)

    def _send(self, message: str | bytes, keep_as: str | None = None) -> None:
        with self._lock:
            if keep_as is not None:
                self._kept[keep_as] = message
            for listener in self._listeners:
                listener(message)

    # --- commands

    def do(self, command: Mapping[str, Any]) -> Future[Json]:
        """Takes a command of a page; the future holds what is answered.

        Its exceptions are ``InputError`` and ``SimulationFailure``.
        """
        name = command.get("do")
        method = getattr(self, f"_do_{name}", None) if isinstance(name, str) and name.isidentifier() else None
        if method is None:
            known = [one.removeprefix("_do_") for one in dir(self) if one.startswith("_do_")]
            failed: Future[Json] = Future()
            failed.set_exception(InputError(f"there is no command {shown(name)}; {did_you_mean(str(name), known)}"))
            return failed
        if name == "set":
            return self._want(command.get("values"))
        arguments = {str(k): v for k, v in command.items() if k not in ("do", "id")}
        return self._thread.submit(self._checked, method, arguments)

    def _checked(self, method: Callable[..., Json | None], arguments: Json) -> Json:
        try:
            return method(**arguments) or {}
        except TypeError as problem:
            if "argument" in str(problem):
                raise InputError(f"the command cannot be used: {problem}") from None
            raise

    def wait(self) -> None:
        """Returns when all that was asked for is done, but for what takes long."""
        self._thread.submit(lambda: None).result()

    # --- values

    def _want(self, values: Any) -> Future[Json]:
        if not isinstance(values, Mapping):
            failed: Future[Json] = Future()
            failed.set_exception(InputError("set wants values by name"))
            return failed
        with self._lock:
            self._wanted |= {str(name): value for name, value in values.items()}
        return self._thread.submit(self._draw_wanted)

    def _draw_wanted(self) -> Json:
        with self._lock:
            wanted, self._wanted = self._wanted, {}
        if wanted:
            self._set(wanted)
        return {"version": self._version}

    def _do_set(self, values: Json) -> Json:
        raise NotImplementedError  # ``do`` keeps the newest of these

    def _set(self, shown_values: Mapping[str, Any]) -> None:
        assert self._opened is not None
        values: dict[str, float] = {}
        for name, number in shown_values.items():
            free = self._parameter(name)
            values[name] = self._number(free, number)
        state = self.state
        step = Step(SET, {"values": values})
        changed = replace(state, values={**state.values, **values}, steps=with_step(state.steps, step))
        self._enter(changed, merge=bool(state.steps and state.steps[-1].do == SET))

    def _parameter(self, name: str) -> Free:
        assert self._opened is not None
        known = self._opened.parameters
        if name not in known:
            raise InputError(f"there is no parameter {shown(name)} to set; {did_you_mean(name, known)}")
        return known[name]

    def _number(self, free: Free, value: Any) -> float:
        assert self._opened is not None
        variable = self._opened.simulator.interface.settable.get(free.parameter)
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not -1e300 < value < 1e300:
            raise InputError(f"{shown(f'{free.name}={value}')}: the value must be a finite number")
        number = float(value) / readable_factor(free.unit)
        if variable is not None and free.name == free.parameter:
            return setting_of(number, variable)
        return number

    def _do_reset(self, names: Sequence[str] | None = None) -> Json:
        assert self._opened is not None
        chosen = list(self._opened.parameters) if names is None else list(names)
        starts = {name: self._parameter(name).start for name in chosen}
        step = Step(SET, {"values": starts})
        self._enter(
            replace(self.state, values={**self.state.values, **starts}, steps=with_step(self.state.steps, step))
        )
        return {"version": self._version}

    # --- models

    def _do_switch(self, effects: Sequence[str]) -> Json:
        self._change_model(self.state.model, tuple(dict.fromkeys(map(str, effects))), "switch")
        return {"version": self._version}

    def _do_choose(self, model: str) -> Json:
        self._change_model(str(model), (), "choose")
        return {"version": self._version}

    def _change_model(self, model: str, effects: tuple[str, ...], do: str) -> None:
        state = self.state
        step = Step("switch", {"effects": list(effects)}) if do == "switch" else Step("choose", {"model": model})
        changed = replace(
            state, model=model, effects=effects, steps=with_step(state.steps, step), before=self._comparison, file=None
        )
        self._enter(changed)

    def _enter(self, state: State, *, merge: bool = False) -> None:
        """Makes a state the present one: everything that depends on it is made anew, or nothing is."""
        opened, before = self._opened, self.state
        other = opened is None or (state.model, state.effects) != (opened.model, opened.effects)
        fresh = open_model(state.data, state.model, state.effects, self.files, self._scratch) if other else opened
        assert fresh is not None
        try:
            comparison = self._compared(state, fresh)
        except BaseException:
            if other:
                fresh.simulator.close()
            raise
        if other and opened is not None:
            opened.simulator.close()
        if not merge:
            self._past.append(before)
        self.state, self._opened, self._comparison = state, fresh, comparison
        self._draw(other or not merge)

    def _compared(self, state: State, opened: Opened) -> Comparison:
        values = {f.name: value_of(f, state) for f in opened.parameters.values()}
        return compare(opened.simulator, state.data, values, rules=False)

    def _do_undo(self) -> Json:
        if not self._past:
            raise InputError("there is no step to take back")
        state = self._past.pop()
        self._enter(state, merge=True)
        return {"version": self._version}

    # --- what is told

    def _open(self) -> None:
        self._opened = open_model(self.state.data, self.state.model, (), self.files, self._scratch)
        self._comparison = self._compared(self.state, self._opened)
        self._send(frame("measured", 0, measured_curves(self.state.data)), "measured")
        self._draw(True)

    def _draw(self, all_of_it: bool) -> None:
        assert self._opened is not None and self._comparison is not None
        self._version += 1
        self._send(frame("model", self._version, model_curves(self._comparison), label_of(self.state)), "model")
        self._tell(scores_event(self.state, self._opened, self._comparison, self._version))
        if all_of_it:
            self._tell_study()
            if self.state.before is not None:
                self._send(frame("reference", self._version, model_curves(self.state.before), "before"), "reference")
        self._tell(steps_event(self.state, self._saved))
        self._later(QUIET, self._tell_where, self._version)

    def _later(self, seconds: float, method: Callable[..., None], *arguments: Any) -> None:
        """Does something in the study's thread after some time, if there still is one."""

        def begin() -> None:
            with suppress(RuntimeError):
                self._thread.submit(method, *arguments)

        timer = threading.Timer(seconds, begin)
        timer.daemon = True
        timer.start()

    def _tell_study(self) -> None:
        assert self._opened is not None
        self._tell(study_event(self.state, self._opened, self._catalogue(), self._benches))

    def _tell_where(self, version: int) -> None:
        """Says where the error sits, unless something newer is drawn already."""
        with self._lock:
            if version != self._version or self._wanted:
                return
        assert self._opened is not None and self._comparison is not None
        interface, data = self._opened.simulator.interface, self.state.data
        about = (self._comparison.runs, data.signals, interface.outputs, data.domain, interface.inputs)
        rules = where(*about)
        self._tell(where_event(rules, [sitting(rule, *about) for rule in rules], version))

    def _catalogue(self) -> tuple[ShownEffect, ...]:
        """Every effect of the model's library, and whether it finds a place in it."""
        model = self.state.model
        if is_fmu(model):
            return ()
        if model not in self._effects:
            sources = [*self.files, Path(model)] if is_modelica(model) else list(self.files)
            tree = read_library(files=sources)
            structure = read_structure(qualified(tree, model), files=sources)
            self._effects[model] = tuple(
                shown_effect(e, (), compose_on(tree, structure, (e.name,)) is not None)
                for e in effect_classes(tree, origins(structure.parts))
            )
        return tuple(replace(e, on=e.name in self.state.effects) for e in self._effects[model])
