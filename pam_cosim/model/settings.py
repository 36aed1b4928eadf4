"""What a run is set to, resolved once against the model: names, units and ranges of values that hold for all of it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import shown

# A number in the model's own (SI) unit, or a text such as "207 kPa", "on", or the name of an enumeration's item.
Setting = float | str


class Text(float):
    """The value of a parameter of type String, where those of all others are numbers."""

    text: str

    def __new__(cls, text: str) -> Text:
        """Of the text itself."""
        setting = super().__new__(cls)
        setting.text = text
        return setting

    def __str__(self) -> str:
        return self.text

    def __format__(self, form: str) -> str:
        return self.text

    def __getnewargs__(self) -> tuple[str]:  # type: ignore[override]
        return (self.text,)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Text) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)


def resolve(settings: Mapping[str, Setting], interface: Interface) -> dict[str, float]:
    """Values by name [SI] of parameters, of inputs that are held constant, and of start values.

    Raises:
        InputError: an unknown name; a value that is no finite number, of another dimension or out of range.
    """
    return {name: value_of(value, settable(name, interface)) for name, value in settings.items()}


def settable(name: str, interface: Interface) -> Variable:
    """What ``name`` stands for.

    Raises:
        InputError: nothing of that name can be set; names the nearest one.
    """
    variables = interface.settable
    if name not in variables:
        raise InputError(interface.unknown(name, "parameter or input", variables))
    return variables[name]


def value_of(value: Setting, variable: Variable) -> float:
    """One value [SI]; a text without a unit is in the model's own unit.

    Raises:
        InputError: as ``resolve``.
    """
    if variable.kind != "Real":
        return discrete_value(value, variable)
    number = _finite(value, variable, difference=False)
    return _within_range(number, value, variable)


def discrete_value(value: Setting, variable: Variable) -> float:
    """A value of a variable that is not Real: a number or a word, or of a String the text.

    Raises:
        InputError: none of the values that the variable may have.
    """
    if variable.kind == "String":
        return Text(str(value))
    number = variable.words.get(str(value).strip().casefold())
    if number is None:
        try:
            number = float(value)
        except (TypeError, ValueError):
            number = np.nan
    if not np.isfinite(number) or not variable.allows(number):
        raise InputError(f"{_said(value, variable)}: must be {variable.values}")
    return _within_range(number, value, variable)


def _within_range(number: float, value: Setting, variable: Variable) -> float:
    low, high = variable.min, variable.max
    if (low is not None and number < low) or (high is not None and number > high):
        raise InputError(f"{_said(value, variable)}: must be {_range(variable)}")
    return number


def size_of(what: str, value: Setting, variable: Variable) -> float:
    """A size above zero [SI], such as an amplitude or a standard deviation: a difference, of which 1 degC is 1 K.

    Raises:
        InputError: as ``resolve``, or the size is not above zero.
    """
    size = _finite(value, variable, difference=True)
    if not size > 0:
        raise InputError(f"{what} must be above zero, not {size:g} {variable.unit}")
    return size


def _finite(value: Setting, variable: Variable, difference: bool) -> float:
    number = _number(value, variable, difference)
    if not np.isfinite(number):
        raise InputError(f"{_said(value, variable)}: the value must be a finite number")
    return number


def _range(variable: Variable) -> str:
    low, high = variable.min, variable.max
    unit = "" if variable.unit == "1" else variable.unit
    span = (
        f"at most {high}"
        if low is None
        else f"at least {low}"
        if high is None
        else f"between {low} and {high}"
    )
    return f"{span} {unit}".rstrip()


def _said(value: Setting, variable: Variable) -> str:
    return shown(f"{variable.name}={value}")


def _number(value: Setting, variable: Variable, difference: bool) -> float:
    try:
        return float(value)
    except TypeError:
        raise InputError(
            f"{_said(value, variable)}: this is neither a number nor a text with a unit"
        ) from None
    except ValueError:
        pass
    try:
        return parse_quantity(value, variable.unit, difference=difference)
    except UnitError as problem:
        raise InputError(f"{_said(value, variable)}: {problem}") from None
