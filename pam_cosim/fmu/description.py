"""The modelDescription.xml of an FMI 2.0 FMU."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from xml.etree import ElementTree as Xml

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import ModelError
from pam_cosim.fmu.structure import Dependencies, continuous_dependencies, initial_dependencies
from pam_cosim.fmu.table import Entry, Kind
from pam_cosim.fmu.units import Unit, parse_unit
from pam_cosim.interface import Variable

_SHARED = {"canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true", "providesDirectionalDerivative": "true"}
_CO_SIMULATION = {
    "canHandleVariableCommunicationStepSize": "true",
    "canInterpolateInputs": "true",
    "maxOutputDerivativeOrder": "1",
}
_LOG_CATEGORIES = ("logStatusWarning", "logStatusError")


def model_identifier(model: str) -> str:
    """A C identifier made from a class name; the binaries carry it."""
    name = re.sub(r"\W", "_", model, flags=re.ASCII)
    return name if name and not name[0].isdigit() else f"_{name}"


def model_description(ode: Ode, entries: Sequence[Entry], guid: str, tool: str) -> bytes:
    """The complete file.

    Raises:
        ModelError: a unit that cannot be read, or a limit that is not a number.
    """
    face = ode.interface
    root = Xml.Element(
        "fmiModelDescription",
        {
            "fmiVersion": "2.0",
            "modelName": face.model,
            "guid": guid,
            **({"description": ode.description} if ode.description else {}),
            "generationTool": tool,
            "variableNamingConvention": "structured",
            "numberOfEventIndicators": "0",
        },
    )
    identifier = {"modelIdentifier": model_identifier(face.model)}
    if not ode.delays:  # nobody tells an FMU for model exchange what its inputs were between two evaluations
        Xml.SubElement(root, "ModelExchange", {**identifier, **_SHARED})
    Xml.SubElement(root, "CoSimulation", {**identifier, **_CO_SIMULATION, **_SHARED})
    _units(root, [entry.variable for entry in entries])
    categories = Xml.SubElement(root, "LogCategories")
    for name in _LOG_CATEGORIES:
        Xml.SubElement(categories, "Category", {"name": name})
    experiment = {
        "startTime": "0.0",
        "stopTime": repr(float(face.stop_time)),
        "tolerance": repr(float(face.tolerance)),
        "stepSize": repr(float(face.interval)),
    }
    Xml.SubElement(root, "DefaultExperiment", experiment)
    variables = Xml.SubElement(root, "ModelVariables")
    positions = {e.index: i for i, e in enumerate(entries, 1) if e.kind is Kind.STATE}
    for entry in entries:
        _variable(variables, entry, positions)
    _structure(root, ode, entries)
    Xml.indent(root)
    return bytes(Xml.tostring(root, encoding="utf-8", xml_declaration=True)) + b"\n"


def _unit_of(variable: Variable, text: str) -> Unit:
    try:
        return parse_unit(text)
    except ModelError as error:
        raise ModelError(f"variable '{variable.name}': {error.message}") from error


def _units(root: Xml.Element, variables: Iterable[Variable]) -> None:
    """UnitDefinitions: every unit in use with the display units asked for."""
    displays: dict[str, dict[str, tuple[float, float]]] = {}
    for variable in variables:
        if not variable.unit:
            continue
        unit = _unit_of(variable, variable.unit)
        shown = displays.setdefault(variable.unit, {})
        if variable.display_unit:
            try:
                shown[variable.display_unit] = _unit_of(variable, variable.display_unit).display(unit)
            except ModelError as error:
                raise ModelError(f"variable '{variable.name}': {error.message}") from error
    if not displays:
        return
    definitions = Xml.SubElement(root, "UnitDefinitions")
    for name in sorted(displays):
        element = Xml.SubElement(definitions, "Unit", {"name": name})
        unit = parse_unit(name)
        base = {symbol: str(exponent) for symbol, exponent in unit.exponents}
        if unit.factor != 1.0:
            base["factor"] = repr(unit.factor)
        if unit.offset != 0.0:
            base["offset"] = repr(unit.offset)
        Xml.SubElement(element, "BaseUnit", base)
        for display, (factor, offset) in sorted(displays[name].items()):
            numbers = {"factor": repr(factor), **({"offset": repr(offset)} if offset else {})}
            Xml.SubElement(element, "DisplayUnit", {"name": display, **numbers})


def _variable(parent: Xml.Element, entry: Entry, state_positions: dict[int, int]) -> None:
    variable = entry.variable
    scalar = {"name": entry.name, "valueReference": str(entry.reference)}
    if variable.description:
        scalar["description"] = variable.description
    scalar |= {"causality": entry.causality, "variability": entry.variability}
    if entry.initial is not None:
        scalar["initial"] = entry.initial
    real = {
        "quantity": variable.quantity,
        "unit": variable.unit,
        "displayUnit": variable.display_unit if variable.unit else "",
        "min": _number(variable.name, "min", variable.min),
        "max": _number(variable.name, "max", variable.max),
        "nominal": _number(variable.name, "nominal", variable.nominal),
        "start": _number(variable.name, "start", entry.start),
    }
    if entry.derivative_of is not None:
        real["derivative"] = str(state_positions[entry.derivative_of])
    element = Xml.SubElement(parent, "ScalarVariable", scalar)
    Xml.SubElement(element, "Real", {key: text for key, text in real.items() if text})


def _number(name: str, attribute: str, value: float | None) -> str:
    """Exact text of a number; limits at infinity are left out."""
    if value is None or (math.isinf(value) and attribute != "start"):
        return ""
    if not math.isfinite(value):
        raise ModelError(f"variable '{name}': its {attribute} value is not a finite number")
    return repr(float(value))


def _structure(root: Xml.Element, ode: Ode, entries: Sequence[Entry]) -> None:
    structure = Xml.SubElement(root, "ModelStructure")
    numbered = list(enumerate(entries, 1))
    outputs = [i for i, e in numbered if e.causality == "output"]
    rates = {e.derivative_of: i for i, e in numbered if e.derivative_of is not None}
    derivatives = [rates[state] for state in range(len(ode.states))]
    initial = sorted(
        {i for i, e in numbered if e.causality == "output" and e.initial == "calculated"}
        | {i for i in derivatives if entries[i - 1].initial == "calculated"}
        | {i for i, e in numbered if e.kind is Kind.STATE and e.initial == "calculated"}
    )
    running = continuous_dependencies(ode, entries)
    _unknowns(structure, "Outputs", outputs, running)
    _unknowns(structure, "Derivatives", derivatives, running)
    _unknowns(structure, "InitialUnknowns", initial, initial_dependencies(ode, entries))


def _unknowns(parent: Xml.Element, name: str, indices: Sequence[int], dependencies: Dependencies) -> None:
    if not indices:
        return
    element = Xml.SubElement(parent, name)
    for index in indices:
        known = " ".join(str(i) for i in dependencies[index])
        Xml.SubElement(element, "Unknown", {"index": str(index), "dependencies": known})
