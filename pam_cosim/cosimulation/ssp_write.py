"""A system of FMUs as an archive of SSP 1.0 or 2.0 that other tools open."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree as Xml

from pam_cosim.cosimulation.parts import Controller, CoupledFmu, Port, joined
from pam_cosim.cosimulation.ssp_names import DESCRIPTION, FMU_TYPE, NAMESPACES, VERSIONS, tag
from pam_cosim.cosimulation.system import System
from pam_cosim.errors import InputError
from pam_cosim.files import check_writable, write_bytes
from pam_cosim.fmu.build import archived
from pam_cosim.fmu.description import base_attributes
from pam_cosim.model.interface import Variable
from pam_cosim.units import UnitError, base_unit

_SYSTEM_VALUES = "SystemStructure.ssv"
_WIDTH, _HEIGHT, _GAP = 40.0, 30.0, 20.0  # of the boxes of a diagram


def write_ssp(
    system: System,
    file: Path,
    version: str = "1.0",
    connectors: bool = True,
) -> Path:
    """Writes the archive: the description, every FMU, and their parameter values as ``.ssv``.

    Args:
        system: the components and their connections.
        file: the archive.
        version: of the standard, "1.0" or "2.0".
        connectors: whether open inputs and all outputs are connectors of the system.

    Raises:
        InputError: a component that is not an FMU, another version, or the file cannot be written.
    """
    if version not in VERSIONS:
        raise InputError(
            f"there is no SSP {version} to write; choose from {', '.join(VERSIONS)}", file
        )
    check_writable(file)
    parts: dict[str, CoupledFmu] = {}
    for name, part in system.components.items():
        if isinstance(part, Controller):
            raise InputError(
                f"component '{name}' is a function in Python, which an SSP archive cannot hold",
                file,
            )
        parts[name] = part
    ports = _ports(system, parts) if connectors else {}
    ends = {end for _, end, _ in ports.values()}
    values = {
        name: {n: value for n, value in values_of_part.items() if Port(name, n) not in ends}
        for name, values_of_part in system.values.items()
    }
    values = {name: values_of_part for name, values_of_part in values.items() if values_of_part}
    stop = system.stop_time or max(p.interface.stop_time for p in parts.values())
    files = {DESCRIPTION: _description(system, parts, ports, values, stop, version)}
    for name, part in parts.items():
        files[f"resources/{name}.fmu"] = part.path.read_bytes()
        if name in values:
            settable = part.interface.settable
            held = {n: (settable[n], value) for n, value in values[name].items()}
            files[f"resources/{name}.ssv"] = _values(held, version)
    held = {
        name: (
            variable,
            system.values.get(end.component, {}).get(end.variable, variable.start or 0.0),
        )
        for name, (kind, end, variable) in ports.items()
        if kind == "input"
    }
    if held:
        files[_SYSTEM_VALUES] = _values(held, version)
    write_bytes(file, archived(files))
    return file


_Ports = Mapping[str, tuple[str, Port, Variable]]


def _ports(system: System, parts: Mapping[str, CoupledFmu]) -> _Ports:
    """Connectors of the system by name, with their kinds: inputs that are not connected, and all outputs."""
    entries = [
        ("input", Port(*name.split(".", 1)), variable) for name, variable in system.inputs.items()
    ]
    for name, part in parts.items():
        entries += [("output", Port(name, n), v) for n, v in part.interface.outputs.items()]
    single = [_identifier(end.variable) for _, end, _ in entries]
    names = [
        name if single.count(name) == 1 else f"{_identifier(end.component)}_{name}"
        for name, (_, end, _) in zip(single, entries, strict=True)
    ]
    return dict(zip(names, entries, strict=True))


def _identifier(text: str) -> str:
    """As tools take it as a name: letters, digits and underscores, no digit first."""
    name = re.sub(r"\W+", "_", text, flags=re.ASCII).strip("_")
    return name if name and not name[0].isdigit() else f"system_{name}".rstrip("_")


def _document(root: Xml.Element) -> bytes:
    for prefix, uri in NAMESPACES.items():
        Xml.register_namespace(prefix, uri)
    Xml.indent(root)
    text = Xml.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def _description(
    system: System,
    parts: Mapping[str, CoupledFmu],
    ports: _Ports,
    values: Collection[str],
    stop_time: float,
    version: str,
) -> bytes:
    title = {"description": system.title} if system.title else {}
    about = {"name": _identifier(system.title or "system"), **title}
    root = Xml.Element(
        tag("ssd", "SystemStructureDescription"),
        {"version": version, **about, "generationTool": "pam-cosim"},
    )
    top = Xml.SubElement(root, tag("ssd", "System"), about)
    if ports:
        _connectors(top, [(kind, name, variable) for name, (kind, _, variable) in ports.items()])
    if any(kind == "input" for kind, _, _ in ports.values()):
        _bound(top, _SYSTEM_VALUES)
    elements = Xml.SubElement(top, tag("ssd", "Elements"))
    for number, (name, part) in enumerate(parts.items()):
        source = {"source": f"resources/{name}.fmu", "type": FMU_TYPE}
        about = {"name": name, **source, "implementation": "CoSimulation"}
        component = Xml.SubElement(elements, tag("ssd", "Component"), about)
        connectors = [("input", n, v) for n, v in part.interface.inputs.items()]
        connectors += [("output", n, v) for n, v in part.interface.outputs.items()]
        _connectors(component, connectors)
        corner = _GAP + number * (_WIDTH + _GAP)
        _box(component, "ElementGeometry", corner, corner + _WIDTH)
        if name in values:
            _bound(component, f"resources/{name}.ssv")
    connections = Xml.SubElement(top, tag("ssd", "Connections"))
    for connection in system.connections:
        element = _wire(connections, connection.source, connection.target)
        plain = joined(connection.source, connection.target, parts)
        if (plain.factor, plain.offset) != (
            connection.factor,
            connection.offset,
        ):  # more than a conversion
            element.set("suppressUnitConversion", "true")
            numbers = {"factor": repr(connection.factor), "offset": repr(connection.offset)}
            Xml.SubElement(element, tag("ssc", "LinearTransformation"), numbers)
    for name, (kind, end, _) in ports.items():
        border = Port("", name)
        _wire(connections, *((border, end) if kind == "input" else (end, border)))
    _box(top, "SystemGeometry", 0, _GAP + len(parts) * (_WIDTH + _GAP))
    faces = [part.interface for part in parts.values()]
    _units(root, "ssd", [v for face in faces for v in (face.inputs | face.outputs).values()])
    experiment = {"startTime": "0.0", "stopTime": repr(float(stop_time))}
    Xml.SubElement(root, tag("ssd", "DefaultExperiment"), experiment)
    return _document(root)


def _bound(element: Xml.Element, source: str) -> None:
    bindings = Xml.SubElement(element, tag("ssd", "ParameterBindings"))
    Xml.SubElement(bindings, tag("ssd", "ParameterBinding"), source=source)


def _wire(connections: Xml.Element, source: Port, target: Port) -> Xml.Element:
    """A connection; a port without a component is a connector of the system."""
    ends = {
        "startElement": source.component,
        "startConnector": source.variable,
        "endElement": target.component,
        "endConnector": target.variable,
    }
    named = {key: text for key, text in ends.items() if text}
    return Xml.SubElement(connections, tag("ssd", "Connection"), named)


def _box(element: Xml.Element, name: str, x1: float, x2: float) -> None:
    corners = {"x1": x1, "y1": 0.0, "x2": x2, "y2": _HEIGHT}
    Xml.SubElement(element, tag("ssd", name), {key: repr(float(x)) for key, x in corners.items()})


def _connectors(element: Xml.Element, ports: Sequence[tuple[str, str, Variable]]) -> None:
    """Inputs on the left side and outputs on the right, each with its unit."""
    listed = Xml.SubElement(element, tag("ssd", "Connectors"))
    for kind, name, variable in ports:
        connector = Xml.SubElement(listed, tag("ssd", "Connector"), name=name, kind=kind)
        unit = {"unit": variable.unit} if _known(variable) else {}
        Xml.SubElement(connector, tag("ssc", "Real"), unit)
        side = [n for k, n, _ in ports if k == kind]
        height = 1.0 - (side.index(name) + 0.5) / len(side)
        place = {"x": "0.0" if kind == "input" else "1.0", "y": repr(round(height, 3))}
        Xml.SubElement(connector, tag("ssd", "ConnectorGeometry"), place)


def _values(values: Mapping[str, tuple[Variable, float]], version: str) -> bytes:
    """A parameter set: values by name, in the units of their variables."""
    root = Xml.Element(tag("ssv", "ParameterSet"), version=version, name="initialValues")
    listed = Xml.SubElement(root, tag("ssv", "Parameters"))
    for name, (variable, value) in values.items():
        parameter = Xml.SubElement(listed, tag("ssv", "Parameter"), name=name)
        unit = {"unit": variable.unit} if _known(variable) else {}
        Xml.SubElement(parameter, tag("ssv", "Real"), {"value": repr(value), **unit})
    _units(root, "ssv", [variable for variable, _ in values.values()])
    return _document(root)


def _known(variable: Variable) -> bool:
    """Whether it has a unit whose relation to the base units can be written down."""
    try:
        return bool(variable.unit) and base_unit(variable.unit) is not None
    except UnitError:
        return False


def _units(root: Xml.Element, prefix: str, variables: Iterable[Variable]) -> None:
    names = sorted({v.unit for v in variables if _known(v)})
    if not names:
        return
    listed = Xml.SubElement(root, tag(prefix, "Units"))
    for name in names:
        element = Xml.SubElement(listed, tag("ssc", "Unit"), name=name)
        Xml.SubElement(element, tag("ssc", "BaseUnit"), base_attributes(name))
