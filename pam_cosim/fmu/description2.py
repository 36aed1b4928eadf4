"""The modelDescription.xml of FMI 2.0."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from xml.etree import ElementTree as Xml

from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu import description as shared
from pam_cosim.fmu.read import TOOL
from pam_cosim.fmu.table import Kind, VariableEntry

_SHARED = {"canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true"}
_CO_SIMULATION = {"canHandleVariableCommunicationStepSize": "true", "canInterpolateInputs": "true"}


def model_description(
    ode: Ode,
    entries: Sequence[VariableEntry],
    guid: str,
    tool: str,
    sources: Sequence[str],
    about: Mapping[str, str],
    *,
    lean: bool = False,
) -> bytes:
    """The complete file; ``sources`` are the C files to compile, ``about`` has author, version and licence.

    ``lean``: without directional derivatives, and without the dependencies in the structure of the model.

    Raises:
        ModelError: a unit that cannot be read, or a limit that is not a number.
    """
    interface = ode.interface
    root = Xml.Element(
        "fmiModelDescription",
        {
            "fmiVersion": "2.0",
            "guid": guid,
            "modelName": interface.model,
            **({"description": ode.description} if ode.description else {}),
            **about,
            "generationTool": tool,
            "variableNamingConvention": shared.naming_convention(entries),
            "numberOfEventIndicators": "0",
        },
    )
    identifier = {"modelIdentifier": shared.model_identifier(interface.model)}
    both = _SHARED | {"providesDirectionalDerivative": str(not lean).lower()}
    if (
        not ode.delays
    ):  # nobody tells an FMU for model exchange what its inputs were between two evaluations
        _source_files(Xml.SubElement(root, "ModelExchange", {**identifier, **both}), sources)
    order = {"maxOutputDerivativeOrder": str(int(not lean))}
    _source_files(
        Xml.SubElement(root, "CoSimulation", {**identifier, **_CO_SIMULATION, **order, **both}),
        sources,
    )
    shared.units(root, [entry.variable for entry in entries])
    shared.log_categories(root)
    shared.default_experiment(root, ode)
    if ode.libraries:
        annotations = Xml.SubElement(root, "VendorAnnotations")
        shared.contents(Xml.SubElement(annotations, "Tool", {"name": TOOL}), ode)
    variables = Xml.SubElement(root, "ModelVariables")
    positions = {e.index: i for i, e in enumerate(entries, 1) if e.kind is Kind.STATE}
    for entry in entries:
        real = shared.real_attributes(entry)
        if entry.derivative_of is not None:
            real["derivative"] = str(positions[entry.derivative_of])
        element = Xml.SubElement(variables, "ScalarVariable", shared.scalar_attributes(entry))
        Xml.SubElement(element, "Real", real)
    _structure(root, ode, entries, lean)
    return shared.document(root, indented=not lean)


def _source_files(kind: Xml.Element, sources: Sequence[str]) -> None:
    if not sources:
        return
    files = Xml.SubElement(kind, "SourceFiles")
    for name in sources:
        Xml.SubElement(files, "File", {"name": name})


def _structure(root: Xml.Element, ode: Ode, entries: Sequence[VariableEntry], lean: bool) -> None:
    structure = Xml.SubElement(root, "ModelStructure")
    unknowns = shared.model_structure(ode, entries, dependencies=not lean)
    same = {i: i for i in range(1, len(entries) + 1)}
    for part, indices, dependencies in (
        ("Outputs", unknowns.outputs, unknowns.running),
        ("Derivatives", unknowns.derivatives, unknowns.running),
        ("InitialUnknowns", unknowns.initial, unknowns.starting),
    ):
        if indices:
            element = Xml.SubElement(structure, part)
            for index in indices:
                shared.unknown(element, "Unknown", "index", index, dependencies, same)
