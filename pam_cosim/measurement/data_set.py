"""What was measured: the product of this room. Every number is in the bench's own (SI) unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.measurement.free_parameter import FreeParameter
from pam_cosim.measurement.run_names import check_names, stated_of
from pam_cosim.measurement.signal import Averaged, Signal
from pam_cosim.measurement.start import Start
from pam_cosim.model.domain import Domain
from pam_cosim.model.references import START_VALUES, is_ratio, parameter_of
from pam_cosim.simulation.inputs import Interpolation
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, did_you_mean, shown

FILE_NAME = "experiment.toml"
Role = Literal["fit", "holdout"]
ROLES: tuple[Role, ...] = get_args(Role)


@dataclass(frozen=True)
class Along:
    """The input that varies along a curve of points at rest, and its unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class Run:
    """One recording of n rows, or one curve of n points at rest.

    Attributes:
        name: the file's path inside the folder, without its ending.
        file: where the run was read from.
        role: "fit", or "holdout": never fitted, only judged.
        interpolation: of the inputs between samples.
        parameters: known values [SI], those of the data set overlaid by those of this run; an input among them is
            constant.
        time: (n,) [s], not decreasing; two rows of equal time are a step. Of a curve, the input that varies along it.
        inputs: (n,) each [SI], without gaps.
        measurements: (n,) each [SI], NaN where a sample is missing.
        default_inputs: inputs that are neither recorded nor known; they keep the model's default.
        notes: what a reader should know of how the file was read.
        averaged: of signals whose samples are means of several.
        more_files: of other loggers.
        along: of a curve of points at rest, what it is drawn over; None: a recording over time.
        start: in which state it begins.
        recorded: first and last time [s] of the recording that it was cut out of; None: it is all of it.
        replaced: what the data set states [SI] of parameters that have another value, by name; None: nothing.
        interpolation_stated: the data set states the interpolation.
    """

    name: str
    file: Path
    role: Role
    interpolation: Interpolation
    parameters: dict[str, float]
    time: NDArray[np.float64]
    inputs: dict[str, NDArray[np.float64]]
    measurements: dict[str, NDArray[np.float64]]
    default_inputs: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    averaged: dict[str, Averaged] = field(default_factory=dict)
    more_files: tuple[Path, ...] = ()
    along: Along | None = None
    start: Start = Start()
    recorded: tuple[float, float] | None = None
    replaced: dict[str, float | None] = field(default_factory=dict)
    interpolation_stated: bool = False

    @property
    def is_static(self) -> bool:
        """Whether it holds points at rest, without time."""
        return self.along is not None

    def sample_count(self, signal: str) -> int:
        """How many samples of ``signal`` the run holds; 0 when it was not measured."""
        values = self.measurements.get(signal)
        return 0 if values is None else int(np.isfinite(values).sum())

    def rows(self, selection: slice) -> Run:
        """The run with some of its rows."""
        return replace(
            self,
            time=self.time[selection],
            inputs={name: values[selection] for name, values in self.inputs.items()},
            measurements={name: values[selection] for name, values in self.measurements.items()},
        )

    def describe(self) -> str:
        """One line: name, role, duration, inputs, samples."""
        measured = ", ".join(f"{name} ({self.sample_count(name)})" for name in self.measurements)
        if self.along is not None:
            low, high = (format_quantity(float(self.time[i]), self.along.unit) for i in (0, -1))
            span = f"{len(self.time)} points at rest, {self.along.name} {low} to {high}"
            return f"{self.name}: {self.role}, {span}, imposed {', '.join(self.inputs)}, samples of {measured}"
        recorded_span = (
            f" of {self.recorded[0]:g} to {self.recorded[1]:g} s" if self.recorded else ""
        )
        span = f"{self.time[0]:g} to {self.time[-1]:g} s{recorded_span}, {len(self.time)} rows"
        inputs = ", ".join(self.inputs) or "none"
        return f"{self.name}: {self.role}, {span}, inputs {inputs} ({self.interpolation}), samples of {measured}"


@dataclass(frozen=True)
class DataSet(Printed):
    """An experiment: the bench, what was measured on it, and what is known of its parameters.

    Attributes:
        folder: where it was read from.
        title: the experimenter's own words.
        model: the bench, as a name that compiles.
        bench: the bench that the description names, where the data were read for another model; else the same.
        unmapped: the model before it got maps of its inputs; empty: it has none that it did not have before.
        signals: the measured outputs.
        parameters: known values for all runs [SI]; fitted parameters are not among them.
        fit: free parameters.
        runs: in the order of the file.
        domain: how results are described in the field of the model.
        excluded: families or names of effects that are known not to be missing. expected: those that are likely.
    """

    folder: Path
    title: str
    model: str
    signals: dict[str, Signal]
    parameters: dict[str, float]
    fit: dict[str, FreeParameter]
    runs: tuple[Run, ...] = field(default=())
    domain: Domain = Domain()
    excluded: tuple[str, ...] = ()
    expected: tuple[str, ...] = ()
    bench: str = ""
    unmapped: str = ""

    def model_for(self, requested: str | None) -> str:
        """The model of a name (None: the bench): with the maps of inputs that these data need."""
        return self.model if requested is None or requested == self.unmapped else requested

    @property
    def fitted_signals(self) -> dict[str, Signal]:
        """The signals that parameters are fitted to and models judged by."""
        return {name: signal for name, signal in self.signals.items() if signal.fitted}

    @property
    def files(self) -> tuple[Path, ...]:
        """What it was read from: its description and its recordings."""
        return (
            self.folder / FILE_NAME,
            *(file for run in self.runs for file in (run.file, *run.more_files)),
        )

    @property
    def free_names(self) -> tuple[str, ...]:
        """Names in the model of what is fitted, each once."""
        return tuple(dict.fromkeys(free.parameter for free in self.fit.values()))

    @property
    def estimates_starts(self) -> bool:
        """Whether start values of some run are parameters."""
        return any(run.start.mode == "estimated" for run in self.runs)

    @property
    def differentiated(self) -> tuple[str, ...]:
        """By what a model is differentiated for a fit: what is free, and start values where they are parameters."""
        return (*self.free_names, *[START_VALUES] * self.estimates_starts)

    @property
    def constants(self) -> dict[str, float]:
        """What all runs have alike [SI] and the data set does not state: also a free parameter that was not fitted."""
        example, *other_runs = self.runs
        alike = {
            n: v
            for n, v in example.parameters.items()
            if all(run.parameters.get(n) == v for run in other_runs)
        }
        return {name: value for name, value in alike.items() if name not in self.parameters}

    @property
    def is_static(self) -> bool:
        """Whether all runs hold points at rest."""
        return all(run.is_static for run in self.runs)

    @property
    def fit_runs(self) -> tuple[Run, ...]:
        """The runs parameters are fitted to."""
        return tuple(run for run in self.runs if run.role == "fit")

    @property
    def holdout_runs(self) -> tuple[Run, ...]:
        """The runs that are only judged."""
        return tuple(run for run in self.runs if run.role == "holdout")

    def with_roles(self, roles: Mapping[str, str]) -> DataSet:
        """The same where these runs are fitted, or held out.

        Args:
            roles: "fit" or "holdout" by the name of a run, or by a pattern such as "test*" for all others.

        Raises:
            InputError: no such run or role, or no run would be left to fit.
        """
        check_names(self.title, roles, [run.name for run in self.runs])
        for role in roles.values():
            if role not in ROLES:
                raise InputError(
                    f"{shown(role)} is no role of a run; it is one of {', '.join(ROLES)}"
                )
        by_name = {
            name: known_role
            for name, role in roles.items()
            for known_role in ROLES
            if known_role == role
        }
        runs = tuple(
            replace(run, role=stated_of(run.name, by_name) or run.role) for run in self.runs
        )
        if roles and not any(run.role == "fit" for run in runs):
            raise InputError("no run would be left to fit")
        return replace(self, runs=runs) if roles else self

    def with_signals(self, sigmas: Mapping[str, float | None]) -> DataSet:
        """The same where just these signals are fitted, and all others compared.

        Args:
            sigmas: noise levels [SI] by name of a signal; None: as it was stated or estimated.

        Raises:
            InputError: no such signal, or none would be left to fit.
        """
        stray = next((name for name in sigmas if name not in self.signals), None)
        if stray is not None:
            raise InputError(f"nothing measures '{stray}'; {did_you_mean(stray, self.signals)}")
        if not sigmas:
            raise InputError("no signal would be left to fit")
        signals = {name: replace(s, fitted=name in sigmas) for name, s in self.signals.items()}
        for name, sigma in sigmas.items():
            if sigma is not None:
                signals[name] = replace(signals[name], sigma=sigma, stated=sigma, estimated=False)
        return replace(self, signals=signals)

    def parameters_of(
        self, run: Run, fitted: Mapping[str, float] | None = None
    ) -> dict[str, float]:
        """What to simulate ``run`` with [SI]: stated start values, ``fitted``, what is known of it, its own ones.

        A fitted value of one run alone has "@" and the run's name after that of the parameter; a ratio to what is
        stated (``references.ratio_to_stated``) is multiplied by that.
        """
        start = {name: free.start for name, free in self.fit.items() if free.start is not None}
        fitted_values = {**start, **(fitted or {})}
        values = self._with_own(
            run, {name: value for name, value in fitted_values.items() if not is_ratio(name)}
        )
        ratios = {
            parameter_of(name): value for name, value in fitted_values.items() if is_ratio(name)
        }
        return values | {
            name: ratio * values[name] for name, ratio in ratios.items() if name in values
        }

    def _with_own(self, run: Run, values: Mapping[str, float]) -> dict[str, float]:
        if not any("@" in name for name in values):
            return {**values, **run.parameters}
        ends = tuple(f"@{other.name}" for other in self.runs)
        shared = {name: value for name, value in values.items() if not name.endswith(ends)}
        end = f"@{run.name}"
        run_values = {
            name.removesuffix(end): value for name, value in values.items() if name.endswith(end)
        }
        return {**shared, **run.parameters, **run_values}

    def notes(self) -> tuple[str, ...]:
        """What a reader of results from these data should know."""
        notes = [] if self.holdout_runs else ["no holdout run: no data remain to check a fit"]
        for name, signal in self.signals.items():
            if signal.assumed:
                notes.append(f"the noise of {name} is not known: it is assumed")
            if not signal.fitted:
                notes.append(f"{name} is compared but not fitted: it has no table [signals.{name}]")
        notes += [*self.starts, *self.steps()]
        for run in self.runs:
            notes += [f"{run.name}: {note}" for note in run.notes]
            if run.default_inputs:
                notes.append(
                    f"{run.name}: model defaults for the inputs {', '.join(run.default_inputs)}"
                )
        return tuple(notes)

    @property
    def starts(self) -> tuple[str, ...]:
        """Where runs begin, in sentences, as far as that was chosen and is not the model's own start."""
        return tuple(run.start.reason for run in self.runs if run.start.reason)

    def steps(self) -> tuple[str, ...]:
        """Which signals are recorded in steps that count, and how they are counted, in sentences."""
        return tuple(
            f"{name} is recorded in steps of {format_quantity(s.step, s.unit)} (quantisation, an instrument): a "
            f"reading counts by its interval, with noise of {format_quantity(s.noise, s.unit)}"
            for name, s in self.signals.items()
            if s.step
        )

    def describe(self) -> str:
        """A readable summary of some lines."""
        lines = [f"{self.title} ({self.model})"]
        for signal in self.signals.values():
            unit = f" {signal.unit}" if signal.unit not in ("", "1") else ""
            lines.append(
                f"  signal {signal.name}: {signal.scatter} {signal.sigma:.3g}{unit} ({signal.source})"
            )
        lines += [f"  known {name} = {value:g}" for name, value in self.parameters.items()]
        for free in self.fit.values():
            start = "the model's default" if free.start is None else f"{free.start:g}"
            prior = f", known as {free.prior.mean:g} ± {free.prior.sd:g}" if free.prior else ""
            lines.append(f"  free {free.name}: {free.min:g} to {free.max:g}, from {start}{prior}")
        lines += [f"  run {run.describe()}" for run in self.runs]
        lines += [f"  note: {note}" for note in self.notes()]
        return "\n".join(lines)

    def __str__(self) -> str:
        return self.describe()
