"""What is compared or fitted: a data set, a model, and the value of every parameter with where it comes from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from pam_cosim.fitting import Free, base_parameters
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_ratio
from pam_cosim.model.settings import Setting
from pam_cosim.problems.corrections import Correction
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed

DATA_SET, DEFAULT = "stated by the data set", "default of the class"


@dataclass(frozen=True)
class ParameterValue:
    """A value with its origin.

    Attributes:
        name: of the parameter, the input that is held constant, or the initial state.
        value: [unit].
        unit: SI unit.
        source: where it comes from.
        free: the bounds between which it is fitted; None: it is not.
    """

    name: str
    value: float
    unit: str
    source: str
    free: tuple[float, float] | None = None


@dataclass(frozen=True)
class ModelValues:
    """Values of a model that differ from the defaults of its base class.

    Attributes:
        label: the model, as messages name it.
        stated: names of parameters to which the model itself gives a value.
        fitted: values of an earlier fit, by name; what the data set or a run states counts before them.
        corrections: that take the place of what the data set states.
        origin: of ``fitted``, as messages name it.
    """

    label: str = ""
    stated: frozenset[str] = frozenset()
    fitted: Mapping[str, Setting] = field(default_factory=dict)
    corrections: tuple[Correction, ...] = ()
    origin: str = "an earlier fit"


@dataclass(frozen=True)
class Problem(Printed):
    """A data set with a model, in which every value is resolved.

    Attributes:
        model: the bench, Modelica class or file that is simulated.
        files: further Modelica files.
        data: the measurement; its runs have the values that count, and its free parameters their initial guesses.
        interface: of the model.
        stated: values of all runs or of single ones beyond what the data set states [SI], by name.
        initial_states: stated or known from a verdict [SI], by "state@run".
        sources: where values come from that the data set does not state, by run and name.
        model_values: values that the model states or was fitted with.
    """

    model: str
    files: tuple[Path, ...]
    data: DataSet
    interface: Interface
    stated: dict[str, float] = field(default_factory=dict)
    initial_states: dict[str, float] = field(default_factory=dict)
    sources: dict[tuple[str, str], str] = field(default_factory=dict)
    model_values: ModelValues = field(default_factory=ModelValues)

    @property
    def free(self) -> tuple[Free, ...]:
        """The parameters that a fit moves, with bounds and initial guesses."""
        return base_parameters(self.data, self.interface)

    @property
    def settings(self) -> dict[str, float]:
        """Stated values and initial states [SI] by name."""
        return {**self.stated, **self.initial_states}

    @property
    def values(self) -> tuple[ParameterValue, ...]:
        """Every parameter, every input that is held constant and every initial state that is stated.

        Once for each value and source that it has.
        """
        named = {name for run in self.data.runs for name in run.parameters}
        other_names = [
            n for n in self.interface.settable if n in named - {*self.interface.parameters}
        ]
        return tuple(
            row for n in [*self.interface.parameters, *other_names] for row in self._rows(n)
        )

    def _rows(self, name: str) -> list[ParameterValue]:
        variable = self.interface.settable[name]
        runs: dict[tuple[float, str], list[str]] = {}
        for run in self.data.runs:
            if name in run.parameters:
                key = run.parameters[name], self._source(run, name)
                runs.setdefault(key, []).append(run.name)
        rows = [
            ParameterValue(name, value, variable.unit, source + self._of_runs(source, names))
            for (value, source), names in runs.items()
        ]
        free = [free_parameter for free_parameter in self.free if free_parameter.parameter == name]
        rows += [
            ParameterValue(
                free_parameter.name,
                free_parameter.start,
                free_parameter.unit,
                "fitted from here",
                (free_parameter.low, free_parameter.high),
            )
            for free_parameter in free
        ]
        runs_with_own = {free_parameter.run for free_parameter in free}
        is_open = any(
            name not in run.parameters and run.name not in runs_with_own for run in self.data.runs
        )
        if is_open and all(
            free_parameter.run or is_ratio(free_parameter.name) for free_parameter in free
        ):
            source = (
                f"stated by {self.model_values.label}"
                if name in self.model_values.stated
                else DEFAULT
            )
            rows.append(ParameterValue(name, variable.start or 0.0, variable.unit, source))
        return rows

    def _source(self, run: Run, name: str) -> str:
        source = self.sources.get((run.name, name), DATA_SET)
        stated = run.replaced.get(name)
        if stated is None:
            return source
        return (
            f"{source}, in place of {format_quantity(stated, self.interface.settable[name].unit)}"
        )

    def _of_runs(self, source: str, names: Sequence[str]) -> str:
        if len(names) == len(self.data.runs):
            return ""
        return f" {'of' if 'in place of' in source else 'for'} {listed(names)}"

    def __str__(self) -> str:
        rows = [
            (value.name, format_quantity(value.value, value.unit), _origin(value))
            for value in self.values
        ]
        widths = [max((len(row[i]) for row in rows), default=0) for i in range(2)]
        lines = [f"{self.interface.model} with {self.data.title}"]
        lines += [
            f"  {name:{widths[0]}}  {value:>{widths[1]}}  {source}" for name, value, source in rows
        ]
        lines += [f"  {run.describe()}" for run in self.data.runs]
        return "\n".join(lines)


def _origin(row: ParameterValue) -> str:
    if row.free is None:
        return row.source
    low, high = (format_quantity(end, row.unit) for end in row.free)
    return f"{row.source}, between {low} and {high}"
