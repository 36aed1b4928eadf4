"""What the name of a stated value refers to: a parameter, an input, an initial state, of all runs or of one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import is_ratio, parameter_of, ratio_to_stated
from pam_cosim.model.settings import Setting, settable, value_of
from pam_cosim.wording import did_you_mean


@dataclass(frozen=True)
class Target:
    """The quantity that a name refers to.

    Attributes:
        name: of the parameter, input or state in the model.
        variable: what the model declares of it; of a ratio, a number without a unit.
        run: the one run that it is of; empty: all.
        ratio: whether the value is a factor on what the data set states.
    """

    name: str
    variable: Variable
    run: str = ""
    ratio: bool = False

    def __str__(self) -> str:
        name = ratio_to_stated(self.name) if self.ratio else self.name
        return f"{name}@{self.run}" if self.run else name


def target(name: str, data: DataSet, interface: Interface) -> Target:
    """The quantity that "load.m", "load.m@run-01" or "load.m/stated" refers to.

    Raises:
        InputError: the model has no such parameter, input or state, or the data set has no such run.
    """
    parameter, at, run = name.rpartition("@")
    if not at or name in interface.settable:
        parameter, run = name, ""
    if is_ratio(parameter):
        settable(parameter_of(parameter), interface)
        return Target(parameter_of(parameter), Variable(name, "1"), run, ratio=True)
    variable = settable(parameter, interface)
    runs = [run_of_data.name for run_of_data in data.runs]
    if at and run and run not in runs:
        raise InputError(f"'{name}': {data.title} has no run '{run}'; {did_you_mean(run, runs)}")
    return Target(parameter, variable, run)


def resolved_values(
    values: Mapping[str, Setting], data: DataSet, interface: Interface
) -> list[tuple[Target, float]]:
    """Stated values [SI] with what they refer to, those of all runs before those of single runs.

    Raises:
        InputError: as ``target``; a value with another dimension, out of range, or that is no finite number.
    """
    pairs = [(target(name, data, interface), value) for name, value in values.items()]
    resolved = [
        (resolved_target, value_of(value, resolved_target.variable))
        for resolved_target, value in pairs
    ]
    return sorted(resolved, key=lambda pair: bool(pair[0].run))
