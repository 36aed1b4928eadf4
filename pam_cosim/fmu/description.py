"""The modelDescription.xml of an FMU: what FMI 2.0 and 3.0 have in common."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as Xml

from pam_cosim.cache import digest
from pam_cosim.catalogue import effects_in
from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import ModelError
from pam_cosim.fmu.structure import Dependencies, continuous_dependencies, initial_dependencies
from pam_cosim.fmu.table import Kind, VariableEntry
from pam_cosim.model.interface import Variable
from pam_cosim.units import BaseUnit, UnitError, base_unit

_FOLLOWING = ("calculated", "approx")  # values of ``initial`` of what initialization finds
_LONGEST = 150
# What XML 1.0 has no place for, not even as a reference.
_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")

_LOG_CATEGORIES = {
    "logEvents": "parameters that change in a run",
    "logStatusWarning": "what may be unexpected",
    "logStatusDiscard": "why a step or an evaluation was not possible",
    "logStatusError": "why a call was refused",
    "logAll": "all of these",
}
# Where a model asks for none: the units that people read, as the command's own output has them.
_DISPLAY = {"Pa/s": "kPa/s", "m2": "mm2", "m3": "l", "kg/s": "g/s"}


def model_identifier(model: str) -> str:
    """A C identifier made from a class name; the binaries carry it, so it is a file name on every system too."""
    name = re.sub(r"\W", "_", model, flags=re.ASCII)
    if len(name) > _LONGEST:
        name = f"{name[: _LONGEST - 17]}_{digest(model)[:16]}"
    return name if name and not name[0].isdigit() else f"_{name}"


def units(root: Xml.Element, variables: Iterable[Variable]) -> None:
    """UnitDefinitions: every unit in use with the requested display units.

    Raises:
        ModelError: a unit that cannot be read.
    """
    displays: dict[str, dict[str, tuple[float, float]]] = {}
    for variable in variables:
        if not variable.unit:
            continue
        unit = _unit_of(variable, variable.unit)
        shown = displays.setdefault(variable.unit, {})
        if display := _display_unit(variable):
            try:
                shown[display] = _unit_of(variable, display).display(unit)
            except UnitError as error:
                raise ModelError(f"variable '{variable.name}': {error}") from error
    if not displays:
        return
    definitions = Xml.SubElement(root, "UnitDefinitions")
    for name in sorted(displays):
        element = Xml.SubElement(definitions, "Unit", {"name": name})
        Xml.SubElement(element, "BaseUnit", base_attributes(name))
        for display, (factor, offset) in sorted(displays[name].items()):
            numbers = {"factor": repr(factor), **({"offset": repr(offset)} if offset else {})}
            Xml.SubElement(element, "DisplayUnit", {"name": display, **numbers})


def base_attributes(unit: str) -> dict[str, str]:
    """A unit in terms of those of SI, as FMI and SSP write it."""
    base = base_unit(unit)
    numbers = {symbol: str(exponent) for symbol, exponent in base.exponents}
    numbers |= {"factor": repr(base.factor)} if base.factor != 1.0 else {}
    return numbers | ({"offset": repr(base.offset)} if base.offset != 0.0 else {})


def _display_unit(variable: Variable) -> str:
    return variable.display_unit or _DISPLAY.get(variable.unit, "")


def _unit_of(variable: Variable, text: str) -> BaseUnit:
    try:
        return base_unit(text)
    except UnitError as error:
        raise ModelError(f"variable '{variable.name}': {error}") from error


def log_categories(root: Xml.Element) -> None:
    """LogCategories."""
    categories = Xml.SubElement(root, "LogCategories")
    for name, description in _LOG_CATEGORIES.items():
        Xml.SubElement(categories, "Category", {"name": name, "description": description})


def default_experiment(root: Xml.Element, ode: Ode) -> None:
    """DefaultExperiment."""
    interface = ode.interface
    experiment = {
        "startTime": "0.0",
        "stopTime": repr(float(interface.stop_time)),
        "tolerance": repr(float(interface.tolerance)),
        "stepSize": repr(float(interface.interval)),
    }
    Xml.SubElement(root, "DefaultExperiment", experiment)


def contents(parent: Xml.Element, ode: Ode) -> None:
    """What the model is made of: libraries with their versions, and the effects in it; FMI 2.0 takes one element."""
    parent = Xml.SubElement(parent, "Contents")
    for name, version in ode.libraries:
        Xml.SubElement(parent, "Library", {"name": name, "version": version})
    for component, effect in effects_in(ode.parts):
        Xml.SubElement(parent, "Effect", {"name": effect, "component": component})


def naming_convention(entries: Sequence[VariableEntry]) -> str:
    """ "structured", unless a name in quotation marks holds what that convention has no place for."""
    plain = all(entry.name.isascii() and "`" not in entry.name for entry in entries)
    return "structured" if plain else "flat"


def scalar_attributes(entry: VariableEntry) -> dict[str, str]:
    """Name, value reference, description, causality, variability and initial of a variable."""
    scalar = {"name": entry.name, "valueReference": str(entry.reference)}
    if entry.variable.description:
        scalar["description"] = entry.variable.description
    scalar |= {"causality": entry.causality, "variability": entry.variability}
    return scalar if entry.initial is None else scalar | {"initial": entry.initial}


def real_attributes(entry: VariableEntry) -> dict[str, str]:
    """Units, limits and start value of a variable, those that it has.

    Raises:
        ModelError: a limit that is not a number.
    """
    variable = entry.variable
    real = {
        "quantity": variable.quantity,
        "unit": variable.unit,
        "displayUnit": _display_unit(variable) if variable.unit else "",
        "min": _number(variable.name, "min", variable.min),
        "max": _number(variable.name, "max", variable.max),
        "nominal": _number(variable.name, "nominal", variable.nominal),
        "start": _number(variable.name, "start", entry.start),
    }
    return {key: text for key, text in real.items() if text}


def _number(name: str, attribute: str, value: float | None) -> str:
    """Exact text of a number; limits at infinity are left out."""
    if value is None or (math.isinf(value) and attribute != "start"):
        return ""
    if not math.isfinite(value):
        raise ModelError(f"variable '{name}': its {attribute} value is not a finite number")
    return repr(float(value))


@dataclass(frozen=True)
class ModelStructure:
    """Unknown variables, by index from 1 in the table of entries, and what they depend on, as far as that is stated."""

    outputs: list[int]
    derivatives: list[int]
    initial: list[int]
    running: Dependencies
    starting: Dependencies


def model_structure(
    ode: Ode, entries: Sequence[VariableEntry], *, dependencies: bool = True
) -> ModelStructure:
    """Outputs, derivatives in the order of the states, and initial unknowns."""
    numbered = dict(enumerate(entries, 1))
    outputs = [i for i, e in numbered.items() if e.causality == "output"]
    rates = {e.derivative_of: i for i, e in numbered.items() if e.derivative_of is not None}
    derivatives = [rates[state] for state in range(len(ode.states))]
    states = [i for i, e in numbered.items() if e.kind is Kind.STATE]
    calculated = [i for i, e in numbered.items() if e.causality == "calculatedParameter"]
    unknowns = sorted({*outputs, *derivatives, *states, *calculated})
    initial = [i for i in unknowns if numbered[i].initial in _FOLLOWING]
    if not dependencies:
        return ModelStructure(outputs, derivatives, initial, {}, {})
    return ModelStructure(
        outputs,
        derivatives,
        initial,
        continuous_dependencies(ode, entries),
        initial_dependencies(ode, entries),
    )


def unknown(
    parent: Xml.Element,
    tag: str,
    key: str,
    index: int,
    dependencies: Dependencies,
    numbers: Mapping[int, int],
) -> None:
    """One unknown; ``numbers`` turns an index into what this version of FMI refers to variables by."""
    sources = dependencies.get(index)
    attributes = {key: str(numbers[index])}
    if sources is not None:
        attributes["dependencies"] = " ".join(str(numbers[d.position]) for d in sources)
    if sources:
        attributes["dependenciesKind"] = " ".join(d.kind for d in sources)
    Xml.SubElement(parent, tag, attributes)


def document(root: Xml.Element, *, indented: bool = True) -> bytes:
    """The file's text. ElementTree escapes what has a meaning in XML; what XML cannot hold becomes U+FFFD."""
    for element in root.iter():
        for key, value in element.attrib.items():
            if not value.isprintable():
                element.set(key, _NOT_XML.sub("\ufffd", value))
    if indented:
        Xml.indent(root)
    return bytes(Xml.tostring(root, encoding="utf-8", xml_declaration=True)) + b"\n"
