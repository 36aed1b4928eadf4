"""The modelDescription.xml of an FMU of FMI 2.0 or 3.0, and the buildDescription.xml of FMI 3.0."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from xml.etree import ElementTree as Xml

from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu import description as parts
from pam_cosim.fmu.read import TOOL
from pam_cosim.fmu.table import Kind, VariableEntry

# What the versions call the same thing: the identity of the FMU, what it can do, and the parts of its structure.
_IDENTITY = {"2.0": "guid", "3.0": "instantiationToken"}
_FLAGS = {
    "2.0": ("canGetAndSetFMUstate", "canSerializeFMUstate"),
    "3.0": ("canGetAndSetFMUState", "canSerializeFMUState"),
}
_DERIVATIVES = {
    "2.0": ("providesDirectionalDerivative",),
    "3.0": ("providesDirectionalDerivatives", "providesAdjointDerivatives"),
}
_INPUTS = {"2.0": {"canInterpolateInputs": "true"}, "3.0": {}}
_UNKNOWNS = {
    "2.0": ("Outputs", "Derivatives", "InitialUnknowns"),
    "3.0": ("Output", "ContinuousStateDerivative", "InitialUnknown"),
}


def model_description(
    ode: Ode,
    fmi: str,
    entries: Sequence[VariableEntry],
    guid: str,
    tool: str,
    about: Mapping[str, str],
    sources: Sequence[str] = (),
    *,
    lean: bool = False,
) -> bytes:
    """The complete file; ``about`` has author, version and licence, ``sources`` are the C files that FMI 2.0 lists.

    ``lean``: without directional derivatives, and without the dependencies in the structure of the model.

    Raises:
        ModelError: a unit that cannot be read, or a limit that is not a number.
    """
    model, is_second = ode.interface.model, fmi == "2.0"
    head = {"fmiVersion": fmi, _IDENTITY[fmi]: guid, "modelName": model}
    head |= {"description": ode.description} if ode.description else {}
    head |= {**about, "generationTool": tool}
    head["variableNamingConvention"] = parts.naming_convention(entries)
    head |= {"numberOfEventIndicators": "0"} if is_second else {}
    root = Xml.Element("fmiModelDescription", head)
    shared = {"modelIdentifier": parts.model_identifier(model)} | dict.fromkeys(_FLAGS[fmi], "true")
    shared |= dict.fromkeys(_DERIVATIVES[fmi], str(not lean).lower())
    # an FMU for model exchange does not get its inputs between two evaluations
    exchange = {} if ode.delays else {"ModelExchange": dict[str, str]()}
    if exchange and ode.statements and not is_second:
        exchange["ModelExchange"] = {"needsCompletedIntegratorStep": "true"}
    steps = {"canHandleVariableCommunicationStepSize": "true", **_INPUTS[fmi]}
    steps["maxOutputDerivativeOrder"] = str(int(not lean))
    for kind, attributes in (exchange | {"CoSimulation": steps}).items():
        element = Xml.SubElement(root, kind, shared | attributes)
        if is_second and sources:
            _files(Xml.SubElement(element, "SourceFiles"), "File", sources)
    parts.units(root, [entry.variable for entry in entries])
    parts.log_categories(root)
    parts.default_experiment(root, ode)
    if ode.libraries and is_second:
        annotations = Xml.SubElement(root, "VendorAnnotations")
        parts.contents(Xml.SubElement(annotations, "Tool", {"name": TOOL}), ode)
    _variables(Xml.SubElement(root, "ModelVariables"), entries, is_second)
    _structure(Xml.SubElement(root, "ModelStructure"), ode, fmi, entries, lean)
    if ode.libraries and not is_second:
        annotations = Xml.SubElement(root, "Annotations")
        parts.contents(Xml.SubElement(annotations, "Annotation", {"type": TOOL}), ode)
    return parts.document(root, indented=not lean)


def _variables(parent: Xml.Element, entries: Sequence[VariableEntry], is_second: bool) -> None:
    """FMI 2.0 refers to a state by its position, and has aliases among the variables."""
    states = {
        e.index: i if is_second else e.reference
        for i, e in enumerate(entries, 1)
        if e.kind is Kind.STATE
    }
    elements: dict[int, Xml.Element] = {}
    for entry in entries:
        real, scalar = parts.real_attributes(entry), parts.scalar_attributes(entry)
        if entry.derivative_of is not None:
            real["derivative"] = str(states[entry.derivative_of])
        if is_second:
            Xml.SubElement(Xml.SubElement(parent, "ScalarVariable", scalar), "Real", real)
        elif entry.alias:
            of_alias = ("name", "description", "displayUnit")
            attributes = {k: v for k, v in (scalar | real).items() if k in of_alias}
            Xml.SubElement(elements[entry.reference], "Alias", attributes)
        else:
            elements[entry.reference] = Xml.SubElement(parent, "Float64", scalar | real)


def _structure(
    parent: Xml.Element, ode: Ode, fmi: str, entries: Sequence[VariableEntry], lean: bool
) -> None:
    structure, is_second = parts.model_structure(ode, entries, dependencies=not lean), fmi == "2.0"
    numbers = {i: i if is_second else entry.reference for i, entry in enumerate(entries, 1)}
    for name, indices, dependencies in zip(
        _UNKNOWNS[fmi],
        (structure.outputs, structure.derivatives, structure.initial),
        (structure.running, structure.running, structure.starting),
        strict=True,
    ):
        holder = Xml.SubElement(parent, name) if is_second and indices else parent
        tag, key = ("Unknown", "index") if is_second else (name, "valueReference")
        for index in indices:
            if is_second or not entries[index - 1].alias:
                parts.unknown(holder, tag, key, index, dependencies, numbers)


def build_description(ode: Ode, sources: Sequence[str]) -> bytes:
    """How the binaries are built from the files in ``sources/``."""
    root = Xml.Element("fmiBuildDescription", {"fmiVersion": "3.0"})
    identifier = parts.model_identifier(ode.interface.model)
    configuration = Xml.SubElement(root, "BuildConfiguration", {"modelIdentifier": identifier})
    _files(
        Xml.SubElement(configuration, "SourceFileSet", {"language": "C99"}), "SourceFile", sources
    )
    return parts.document(root)


def _files(parent: Xml.Element, tag: str, names: Sequence[str]) -> None:
    for name in names:
        Xml.SubElement(parent, tag, {"name": name})
