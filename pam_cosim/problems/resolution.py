"""The values of a problem, resolved a source after the other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.fitting import free_parameter, model_parameter
from pam_cosim.measurement import DataSet, FreeParameter, Run, StartMode
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_ratio, ratio_to_stated
from pam_cosim.model.settings import Setting, value_of
from pam_cosim.problems.corrections import Correction
from pam_cosim.problems.names import Target, resolved_values, target
from pam_cosim.problems.problem import ModelValues, Problem
from pam_cosim.units import format_quantity
from pam_cosim.wording import listed, shown

_CALLER = "stated by the caller"
_HELD = "held at its initial guess"


def problem(
    data: DataSet,
    model: str,
    interface: Interface,
    files: Sequence[Path] = (),
    *,
    model_values: ModelValues | None = None,
    values: Mapping[str, Setting] | None = None,
    free: Sequence[str] | None = None,
    guesses: Mapping[str, Setting] | None = None,
) -> Problem:
    """Resolves the value of every parameter of every run, once.

    A later source counts before an earlier one: the default of the class, the model or an earlier fit, the data set,
    the run, what a verdict corrected, the caller.

    Args:
        data: the measurement, as it was read.
        model: that is simulated.
        interface: of the model.
        files: further Modelica files.
        model_values: values that the model states or was fitted with.
        values: of the caller, by name: numbers [SI] or texts with a unit; "load.m@run-01" is of one run,
            "load.m/stated" a factor on what the data set states, "gas.p@run-01" an initial state. A parameter that the
            data set leaves free is held there.
        free: names of the parameters that are fitted, instead of those of the data set: any parameter that has bounds,
            or that the data set states.
        guesses: where the fit of a parameter begins, by name.

    Raises:
        InputError: an unknown name or run; a value that cannot be used; a parameter that cannot be fitted.
    """
    if isinstance(free, str | Mapping):
        raise InputError(f"free is a list of names, as free=['valve.C_A'], not {shown(free)}")
    return _Resolution(data, model, interface, files, model_values or ModelValues()).resolved(
        dict(values or {}),
        None if free is None else tuple(dict.fromkeys(free)),
        dict(guesses or {}),
    )


class _Resolution:
    """The values of one problem in the making, a layer after the other."""

    def __init__(
        self,
        data: DataSet,
        model: str,
        interface: Interface,
        files: Sequence[Path],
        model_values: ModelValues,
    ) -> None:
        self.data, self.model, self.interface, self.files = data, model, interface, files
        self.model_values = model_values
        self.runs = {run.name: run for run in data.runs}
        self.fit = dict(data.fit)
        self.stated: dict[str, float] = {}
        self.initial_states: dict[str, float] = {}
        self.sources: dict[tuple[str, str], str] = {}

    def resolved(
        self,
        values: Mapping[str, Setting],
        free: Sequence[str] | None,
        guesses: Mapping[str, Setting],
    ) -> Problem:
        self._earlier_fit()
        for correction in self.model_values.corrections:
            self._correct(correction)
        self._note_missing_runs()
        for named, value in resolved_values(values, self.data, self.interface):
            if named.ratio and named.name in values:
                raise InputError(
                    f"'{ratio_to_stated(named.name)}' is a factor on what the data set states, and '{named.name}' is "
                    "stated too: state one of the two"
                )
            self._state(named, value)
        chosen = self._guesses(guesses, free)
        if free is not None:
            self._free(free, chosen)
        fitted = [run for run in self.runs.values() if run.role == "fit"]
        self.fit = {
            name: entry
            for name, entry in self.fit.items()
            if is_ratio(name)
            or entry.run
            or any(entry.parameter not in r.parameters for r in fitted)
        }
        runs = tuple(self.runs.values())
        data = replace(self.data, model=self.model, fit=self.fit, runs=runs)
        return Problem(
            self.model,
            tuple(self.files),
            data,
            self.interface,
            self.stated,
            self.initial_states,
            self.sources,
            self.model_values,
        )

    def _earlier_fit(self) -> None:
        """Values of the model and of an earlier fit, where the data set states none."""
        fitted_values = resolved_values(self.model_values.fitted, self.data, self.interface)
        numbers = {str(named): value for named, value in fitted_values}
        for name, entry in self.fit.items():
            if name in numbers:
                self.fit[name] = replace(entry, start=numbers[name])
            elif entry.parameter in self.model_values.stated:
                self.fit[name] = replace(entry, start=None)
        source = f"stated by {self.model_values.origin}"
        for named, value in fitted_values:
            name = str(named)
            if named.ratio or named.run:
                self._state(named, value, source)
                continue
            open_runs = [run for run in self.runs.values() if named.name not in run.parameters]
            for run in self.runs.values():
                if named.name in run.parameters:
                    text = (
                        f"the data set states {name}, and its value is used instead of that of "
                        f"{self.model_values.origin}"
                    )
                    self._note(run.name, text)
            if open_runs:
                self.stated[name] = value
            for run in open_runs if name not in self.fit else ():
                self._put(run.name, name, value, source)

    def _correct(self, correction: Correction) -> None:
        """A value that a verdict found, unless the data set states another one by now."""
        source = f"corrected by the verdict in {self.model_values.label}"
        for run in self.runs.values() if not correction.run else [self.runs.get(correction.run)]:
            if run is None or correction.name not in self.interface.settable:
                continue
            if correction.name in self.interface.states:
                mode: StartMode = "estimated" if correction.estimated else "measured"
                self._begin(run, correction.name, correction.value, source, run.start.mode or mode)
                continue
            stated = run.replaced.get(correction.name, run.parameters.get(correction.name))
            if correction.applies_to(stated):
                self._put(run.name, correction.name, correction.value, source)
            elif stated is not None and stated != correction.value:
                self._note(run.name, self._overruled(correction, stated))

    def _note_missing_runs(self) -> None:
        """Warns of values of runs that the data set does not have."""
        missing = {
            correction.run: None
            for correction in self.model_values.corrections
            if correction.run not in {"", *self.runs}
        }
        if missing:
            text = (
                f"the verdict in {self.model_values.label} has values of {listed(missing)}, which are no runs of the "
                "data set: these values are not used"
            )
            self._note(next(iter(self.runs)), text)

    def _overruled(self, correction: Correction, stated: float) -> str:
        unit = self.interface.settable[correction.name].unit
        before = (
            "nothing" if correction.stated is None else format_quantity(correction.stated, unit)
        )
        return (
            f"the data set states {correction.name} = {format_quantity(stated, unit)}, and it stated {before} when "
            f"the verdict in {self.model_values.label} found {format_quantity(correction.value, unit)}: "
            "the stated value is used"
        )

    def _note(self, run: str, text: str) -> None:
        notes = (*self.runs[run].notes, text)
        self.runs[run] = replace(self.runs[run], notes=notes)

    def _state(self, named: Target, value: float, source: str = _CALLER) -> None:
        """A value that counts before what the data set states."""
        runs = [self.runs[named.run]] if named.run else list(self.runs.values())
        if named.name in self.interface.states:
            for run in runs:
                mode: StartMode = "rest" if run.start.mode == "rest" else "measured"
                self._begin(run, named.name, value, source, mode)
            return
        for run in runs:
            number = value * self._stated_in(run, named.name) if named.ratio else value
            number = value_of(number, self.interface.settable[named.name])
            self._put(run.name, named.name, number, source)
        if not named.ratio:
            self.stated[str(named)] = value
        self.fit = {
            name: entry
            for name, entry in self.fit.items()
            if entry.parameter != named.name or (named.run and entry.run != named.run)
        }

    def _stated_in(self, run: Run, name: str) -> float:
        if name not in run.parameters:
            raise InputError(
                f"'{ratio_to_stated(name)}' is a factor on the value that {run.name} states, and it states none: "
                f"state '{name}' itself"
            )
        return run.replaced.get(name) or run.parameters[name]

    def _put(self, run_name: str, name: str, value: float, source: str) -> None:
        run = self.runs[run_name]
        if run.along is not None and run.along.name == name:
            raise InputError(
                f"'{name}' varies along the points of {run_name} and cannot be held constant"
            )
        stated_first = run.replaced.get(name, run.parameters.get(name))
        self.runs[run_name] = replace(
            run,
            parameters={**run.parameters, name: value},
            replaced=run.replaced if source == _HELD else {**run.replaced, name: stated_first},
            inputs={n: column for n, column in run.inputs.items() if n != name},
            default_inputs=tuple(n for n in run.default_inputs if n != name),
        )
        self.sources[run_name, name] = source

    def _begin(
        self, run: Run, state: str, value: float, source: str, mode: StartMode | None
    ) -> None:
        """A run whose simulation, or the estimate of its start, begins at a value of a state."""
        self.initial_states[f"{state}@{run.name}"] = value
        self._put(run.name, state, value, source)
        start = replace(run.start, mode=mode)
        self.runs[run.name] = replace(self.runs[run.name], start=start)

    def _guesses(
        self, guesses: Mapping[str, Setting], free: Sequence[str] | None
    ) -> dict[str, float]:
        """Where fits begin [SI]; initial states among them are where runs, or the estimates of these, begin."""
        chosen: dict[str, float] = {}
        for named, value in resolved_values(guesses, self.data, self.interface):
            name = str(named)
            if named.run and named.name in self.interface.states:
                run = self.runs[named.run]
                self._begin(run, named.name, value, "initial guess", run.start.mode)
            elif name in self.fit:
                self.fit[name] = _begun_at(self.fit[name], value)
            elif name not in (free or ()):
                raise InputError(
                    f"'{name}' has an initial guess and is not free; "
                    f"free are {listed([*self.fit, *(free or ())])}; a value that is to be held is stated by --set"
                )
            chosen[name] = value
        return chosen

    def _free(self, names: Sequence[str], guesses: Mapping[str, float]) -> None:
        """Only these are free: other free parameters of the data set are held, and its values of these are not used."""
        declared = self.fit
        self.fit = {name: self._entry(name, declared, guesses) for name in names}
        for name, entry in declared.items():
            if name in names:
                continue
            start = free_parameter(entry, self.data, self.interface).start
            for run in list(self.runs.values()):
                is_of_run = entry.run == run.name
                if is_of_run or (not entry.run and entry.parameter not in run.parameters):
                    self._put(run.name, entry.parameter, start, _HELD)

    def _entry(
        self, name: str, declared: Mapping[str, FreeParameter], guesses: Mapping[str, float]
    ) -> FreeParameter:
        named = target(name, self.data, self.interface)
        if named.ratio and named.run:
            raise InputError(
                f"'{name}': a factor is fitted for all runs; fit '{named.name}@{named.run}' instead"
            )
        if named.run and self.runs[named.run].role == "holdout":
            raise InputError(
                f"'{name}' is of a run that is held out and never fitted: state its value by --set"
            )
        stated = self._release(named)
        if name in declared:
            return declared[name]
        if named.ratio:
            for run in self.runs.values():
                self._stated_in(run, named.name)
        entry = _bounded(named, stated, self.interface)
        guess = guesses.get(name, stated)
        return entry if guess is None else _begun_at(entry, guess)

    def _release(self, named: Target) -> float | None:
        """What the data set states of a parameter that is to be fitted, which counts no longer; None: nothing.

        Raises:
            InputError: runs state different values.
        """
        if named.ratio:
            return None
        runs = [self.runs[named.run]] if named.run else list(self.runs.values())
        held = {r.name for r in runs if self.sources.get((r.name, named.name)) == _CALLER}
        if held and all(run.name in held for run in runs if run.role == "fit"):
            raise InputError(
                f"'{named.name}' is to be fitted, and the caller states its value for every fitted run: state an "
                "initial guess by --start, or leave it out of --free"
            )
        stating = [run for run in runs if named.name in run.parameters and run.name not in held]
        runs_by_value = {run.parameters[named.name]: run.name for run in stating}
        if len(runs_by_value) > 1:
            texts = listed(
                f"{format_quantity(value, named.variable.unit)} in {run}"
                for value, run in runs_by_value.items()
            )
            raise InputError(
                f"'{named.name}' has one value for all runs if it is fitted, and the runs state several ({texts}): fit "
                f"the factor on these, --free '{ratio_to_stated(named.name)}', or the value of one run, "
                f"--free '{named.name}@{next(iter(runs_by_value.values()))}'"
            )
        for run in stating:
            stated = run.replaced.get(named.name, run.parameters[named.name])
            self.runs[run.name] = replace(
                run,
                parameters={n: v for n, v in run.parameters.items() if n != named.name},
                replaced={**run.replaced, named.name: stated},
            )
        return next(iter(runs_by_value), None)


def _begun_at(entry: FreeParameter, value: float) -> FreeParameter:
    """The parameter with an initial guess.

    Raises:
        InputError: the guess lies outside the bounds.
    """
    if not entry.min <= value <= entry.max:
        low, guess, high = (format_quantity(v, entry.unit) for v in (entry.min, value, entry.max))
        raise InputError(
            f"'{entry.name}' is fitted between {low} and {high}, and its initial guess {guess} lies outside: "
            "state a guess within the bounds, or wider bounds under [fit]"
        )
    return replace(entry, start=value)


def _bounded(named: Target, stated: float | None, interface: Interface) -> FreeParameter:
    """A parameter between the bounds of the model; else within the range that is searched for a wrong stated value.

    Raises:
        InputError: it has no bounds and no stated value, or is an input or a state.
    """
    if named.name not in interface.parameters:
        raise InputError(f"'{named}' is no parameter of {interface.model} and cannot be fitted")
    if stated and (named.variable.min is None or named.variable.max is None):
        low, start, high = sorted(stated * ratio for ratio in CRITERIA.search.stated_ratio)
        return FreeParameter(str(named), low, high, start, named.variable.unit, run=named.run)
    free = model_parameter(str(replace(named, run="")), interface)
    return FreeParameter(str(named), free.low, free.high, free.start, free.unit, run=named.run)
