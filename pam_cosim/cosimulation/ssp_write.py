"""A system of FMUs as an archive of SSP 1.0 or 2.0 that other tools open."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from xml.etree import ElementTree as Xml

from pam_cosim.cosimulation.parts import Controller, CoupledFmu, joined
from pam_cosim.cosimulation.ssp_names import DESCRIPTION, FMU_TYPE, NAMESPACES, REALS, VERSIONS, tag
from pam_cosim.cosimulation.system import System
from pam_cosim.errors import InputError
from pam_cosim.files import check_writable, write_bytes
from pam_cosim.model.interface import Variable
from pam_cosim.units import UnitError, base_unit

_FIXED = (1980, 1, 1, 0, 0, 0)  # so that the same system gives the same bytes


def write_ssp(
    system: System, file: Path, stop_time: float | None = None, version: str = "1.0"
) -> Path:
    """Writes the archive: the description, every FMU, and their parameter values as ``.ssv``.

    Args:
        system: the components and their connections.
        file: the archive.
        stop_time: of the default experiment [s]; None: that of the system.
        version: of the standard, "1.0" or "2.0".

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
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        _add(
            archive,
            DESCRIPTION,
            _description(system, parts, stop_time or system.stop_time, version),
        )
        for name, part in parts.items():
            _add(archive, f"resources/{name}.fmu", part.path.read_bytes())
            if system.values.get(name):
                _add(
                    archive,
                    f"resources/{name}.ssv",
                    _values(name, part, system.values[name], version),
                )
    write_bytes(file, content.getvalue())
    return file


def _add(archive: zipfile.ZipFile, name: str, content: bytes) -> None:
    entry = zipfile.ZipInfo(name, _FIXED)
    entry.compress_type = zipfile.ZIP_DEFLATED
    archive.writestr(entry, content)


def _document(root: Xml.Element) -> bytes:
    for prefix, uri in NAMESPACES.items():
        Xml.register_namespace(prefix, uri)
    Xml.indent(root)
    text = Xml.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'.encode()


def _description(
    system: System, parts: Mapping[str, CoupledFmu], stop_time: float | None, version: str
) -> bytes:
    title = system.title or "system"
    about = {"version": version, "name": title, "generationTool": "pam-cosim"}
    root = Xml.Element(tag("ssd", "SystemStructureDescription"), about)
    top = Xml.SubElement(root, tag("ssd", "System"), name="system")
    elements = Xml.SubElement(top, tag("ssd", "Elements"))
    for name, part in parts.items():
        source = f"resources/{name}.fmu"
        component = Xml.SubElement(
            elements, tag("ssd", "Component"), name=name, source=source, type=FMU_TYPE
        )
        _connectors(component, part, REALS[version])
        if system.values.get(name):
            bindings = Xml.SubElement(component, tag("ssd", "ParameterBindings"))
            Xml.SubElement(bindings, tag("ssd", "ParameterBinding"), source=f"resources/{name}.ssv")
    if system.connections:
        connections = Xml.SubElement(top, tag("ssd", "Connections"))
        for one in system.connections:
            ends = {
                "startElement": one.source.component,
                "startConnector": one.source.variable,
                "endElement": one.target.component,
                "endConnector": one.target.variable,
            }
            plain = joined(one.source, one.target, parts)
            element = Xml.SubElement(connections, tag("ssd", "Connection"), ends)
            if (plain.factor, plain.offset) != (
                one.factor,
                one.offset,
            ):  # more than a conversion of units
                element.set("suppressUnitConversion", "true")
                numbers = {"factor": repr(one.factor), "offset": repr(one.offset)}
                Xml.SubElement(element, tag("ssc", "LinearTransformation"), numbers)
    _units(root, "ssd", [v for part in parts.values() for v in _ports(part)])
    if stop_time is not None:
        Xml.SubElement(
            root, tag("ssd", "DefaultExperiment"), startTime="0.0", stopTime=repr(float(stop_time))
        )
    return _document(root)


def _ports(part: CoupledFmu) -> Iterable[Variable]:
    return [*part.interface.inputs.values(), *part.interface.outputs.values()]


def _connectors(component: Xml.Element, part: CoupledFmu, real: str) -> None:
    listed = Xml.SubElement(component, tag("ssd", "Connectors"))
    for kind, variables in (("input", part.interface.inputs), ("output", part.interface.outputs)):
        for variable in variables.values():
            connector = Xml.SubElement(
                listed, tag("ssd", "Connector"), name=variable.name, kind=kind
            )
            Xml.SubElement(
                connector, tag("ssc", real), {"unit": variable.unit} if _known(variable) else {}
            )


def _values(name: str, part: CoupledFmu, values: Mapping[str, float], version: str) -> bytes:
    root = Xml.Element(tag("ssv", "ParameterSet"), version=version, name=name)
    listed = Xml.SubElement(root, tag("ssv", "Parameters"))
    used = []
    for variable_name, value in values.items():
        variable = part.interface.settable[variable_name]
        used.append(variable)
        parameter = Xml.SubElement(listed, tag("ssv", "Parameter"), name=variable_name)
        unit = {"unit": variable.unit} if _known(variable) else {}
        Xml.SubElement(parameter, tag("ssv", REALS[version]), {"value": repr(value), **unit})
    _units(root, "ssv", used)
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
        unit = base_unit(name)
        numbers = {symbol: str(exponent) for symbol, exponent in unit.exponents}
        numbers |= {"factor": repr(unit.factor)} if unit.factor != 1.0 else {}
        numbers |= {"offset": repr(unit.offset)} if unit.offset != 0.0 else {}
        Xml.SubElement(
            Xml.SubElement(listed, tag("ssc", "Unit"), name=name), tag("ssc", "BaseUnit"), numbers
        )
