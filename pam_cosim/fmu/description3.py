"""The modelDescription.xml and buildDescription.xml of FMI 3.0."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from xml.etree import ElementTree as Xml

from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu import description as shared
from pam_cosim.fmu.read import TOOL
from pam_cosim.fmu.table import Kind, VariableEntry

_SHARED = {
    "canGetAndSetFMUState": "true",
    "canSerializeFMUState": "true",
    "providesDirectionalDerivatives": "true",
    "providesAdjointDerivatives": "true",
}
_CO_SIMULATION = {"canHandleVariableCommunicationStepSize": "true", "maxOutputDerivativeOrder": "1"}


def model_description(
    ode: Ode,
    entries: Sequence[VariableEntry],
    token: str,
    tool: str,
    about: Mapping[str, str],
) -> bytes:
    """The complete file; ``about`` has author, version and licence.

    Raises:
        ModelError: a unit that cannot be read, or a limit that is not a number.
    """
    interface = ode.interface
    root = Xml.Element(
        "fmiModelDescription",
        {
            "fmiVersion": "3.0",
            "instantiationToken": token,
            "modelName": interface.model,
            **({"description": ode.description} if ode.description else {}),
            **about,
            "generationTool": tool,
            "variableNamingConvention": shared.naming_convention(entries),
        },
    )
    identifier = {"modelIdentifier": shared.model_identifier(interface.model)}
    if (
        not ode.delays
    ):  # nobody tells an FMU for model exchange what its inputs were between two evaluations
        asked = {"needsCompletedIntegratorStep": "true"} if ode.statements else {}
        Xml.SubElement(root, "ModelExchange", {**identifier, **asked, **_SHARED})
    Xml.SubElement(root, "CoSimulation", {**identifier, **_SHARED, **_CO_SIMULATION})
    shared.units(root, [entry.variable for entry in entries])
    shared.log_categories(root)
    shared.default_experiment(root, ode)
    variables = Xml.SubElement(root, "ModelVariables")
    references = {e.index: e.reference for e in entries if e.kind is Kind.STATE}
    elements: dict[int, Xml.Element] = {}
    for entry in entries:
        real, scalar = shared.real_attributes(entry), shared.scalar_attributes(entry)
        if entry.alias:
            described = scalar | {key: real[key] for key in real if key == "displayUnit"}
            both = {
                k: described[k] for k in described if k in ("name", "description", "displayUnit")
            }
            Xml.SubElement(elements[entry.reference], "Alias", both)
            continue
        if entry.derivative_of is not None:
            real["derivative"] = str(references[entry.derivative_of])
        elements[entry.reference] = Xml.SubElement(variables, "Float64", scalar | real)
    _structure(root, ode, entries)
    if ode.libraries:
        annotations = Xml.SubElement(root, "Annotations")
        shared.contents(Xml.SubElement(annotations, "Annotation", {"type": TOOL}), ode)
    return shared.document(root)


def _structure(root: Xml.Element, ode: Ode, entries: Sequence[VariableEntry]) -> None:
    structure = Xml.SubElement(root, "ModelStructure")
    unknowns = shared.model_structure(ode, entries)
    references = {i: entry.reference for i, entry in enumerate(entries, 1)}
    for tag, indices, dependencies in (
        ("Output", unknowns.outputs, unknowns.running),
        ("ContinuousStateDerivative", unknowns.derivatives, unknowns.running),
        ("InitialUnknown", unknowns.initial, unknowns.starting),
    ):
        for index in indices:
            if not entries[index - 1].alias:
                shared.unknown(structure, tag, "valueReference", index, dependencies, references)


def build_description(ode: Ode, sources: Sequence[str]) -> bytes:
    """How the binaries are built from the files in ``sources/``."""
    root = Xml.Element("fmiBuildDescription", {"fmiVersion": "3.0"})
    identifier = shared.model_identifier(ode.interface.model)
    configuration = Xml.SubElement(root, "BuildConfiguration", {"modelIdentifier": identifier})
    files = Xml.SubElement(configuration, "SourceFileSet", {"language": "C99"})
    for name in sources:
        Xml.SubElement(files, "SourceFile", {"name": name})
    return shared.document(root)
