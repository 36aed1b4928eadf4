"""The description of an archive of SSP: FMUs, systems, wires and values of parameters."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from lxml import etree

from pam_cosim.cosimulation.ssp_entries import SspEntries
from pam_cosim.cosimulation.ssp_names import DESCRIPTION, FMU_TYPE, NAMESPACES
from pam_cosim.errors import InputError
from pam_cosim.model.settings import Setting

_MOST_SYSTEMS = 50  # one inside the other
Place = tuple[str, ...]  # names of the systems around an element, and its own


@dataclass(frozen=True)
class Wire:
    """A connection as the archive has it."""

    start: tuple[Place, str]
    end: tuple[Place, str]
    factor: float = 1.0
    offset: float = 0.0
    convert: bool = True


@dataclass
class Description:
    """The description of an archive."""

    title: str
    stop_time: float | None = None
    sources: dict[Place, str] = field(default_factory=dict)
    systems: set[Place] = field(default_factory=set)
    wires: list[Wire] = field(default_factory=list)
    values: list[tuple[Place, str, Setting]] = field(default_factory=list)


def description_of(entries: SspEntries) -> Description:
    """The description of an archive.

    Raises:
        InputError: it has none, one that is not of SSP, or one without components.
    """
    root = entries.tree(DESCRIPTION, "the description", "SystemStructureDescription.xsd")
    system = root.find("ssd:System", NAMESPACES)
    experiment = root.find("ssd:DefaultExperiment", NAMESPACES)
    description = Description(_plain(root.get("description") or root.get("name")))
    if experiment is not None and experiment.get("stopTime"):
        begin, end = float(experiment.get("startTime") or 0.0), float(experiment.get("stopTime"))
        if not (math.isfinite(end - begin) and end > begin):
            raise InputError(
                f"{DESCRIPTION}: stopTime {end:g} s is no time after the start, {begin:g} s",
                entries.file,
            )
        description.stop_time = end - begin
    _system(entries, system, (), description)
    if not description.sources:
        raise InputError("the system has no components", entries.file)
    return description


def _system(entries: SspEntries, system: Any, place: Place, description: Description) -> None:
    if len(place) > _MOST_SYSTEMS:
        raise InputError("systems are nested too deeply", entries.file)
    description.systems.add(place)
    _bindings(entries, system, place, description)
    for element in system.iterfind("ssd:Elements/*", NAMESPACES):
        kind = etree.QName(element).localname
        own_place = (*place, _plain(str(element.get("name"))))
        if kind == "System":
            _system(entries, element, own_place, description)
        elif kind != "Component" or element.get("type", FMU_TYPE) != FMU_TYPE:
            raise InputError(
                f"'{'.'.join(own_place)}' is not an FMU ({_plain(element.get('type', kind))})",
                entries.file,
            )
        elif own_place in description.sources:
            raise InputError(f"there are two components '{'.'.join(own_place)}'", entries.file)
        else:
            description.sources[own_place] = str(element.get("source"))
            _bindings(entries, element, own_place, description)
    for element in system.iterfind("ssd:Connections/ssd:Connection", NAMESPACES):
        description.wires.append(_wire(entries, element, place))


def _wire(entries: SspEntries, element: Any, place: Place) -> Wire:
    def end(which: str) -> tuple[Place, str]:
        name = element.get(f"{which}Element")
        return ((*place, _plain(name)) if name else place), _plain(
            str(element.get(f"{which}Connector"))
        )

    plain = element.get("suppressUnitConversion") in ("true", "1")
    for child in element:
        kind = etree.QName(child).localname
        if kind == "LinearTransformation":
            factor, offset = (
                float(child.get(key, default))
                for key, default in (("factor", 1.0), ("offset", 0.0))
            )
            return Wire(end("start"), end("end"), factor, offset, not plain)
        if kind.endswith("Transformation"):
            raise InputError(
                f"a connection has a {kind}; only linear ones of real signals are read",
                entries.file,
            )
    return Wire(end("start"), end("end"), convert=not plain)


def _bindings(entries: SspEntries, element: Any, place: Place, description: Description) -> None:
    for binding in element.iterfind("ssd:ParameterBindings/ssd:ParameterBinding", NAMESPACES):
        mapping = _mapping(entries, binding.find("ssd:ParameterMapping", NAMESPACES))
        if binding.get("source"):
            if binding.get("sourceBase", "SSD") != "SSD":
                raise InputError("parameter values inside an FMU are not read", entries.file)
            source = binding.get("source")
            sets = [entries.tree(source, "a parameter set", "SystemStructureParameterValues.xsd")]
        else:
            sets = binding.findall("ssd:ParameterValues/ssv:ParameterSet", NAMESPACES)
        prefix = binding.get("prefix", "")
        for parameter_set in sets:
            for parameter in parameter_set.iterfind("ssv:Parameters/ssv:Parameter", NAMESPACES):
                name, value = prefix + parameter.get("name"), _value(entries, parameter)
                for target, transformation in (
                    [(name, None)] if mapping is None else mapping.get(name, [])
                ):
                    description.values.append(
                        (place, _plain(target), _transformed(entries, value, transformation))
                    )


def _mapping(entries: SspEntries, element: Any) -> dict[str, list[tuple[str, Any]]] | None:
    """Names of parameters to the names that they stand for, with how their values change; None: by their own names."""
    if element is None:
        return None
    if element.get("source"):
        root = entries.tree(
            element.get("source"), "a parameter mapping", "SystemStructureParameterMapping.xsd"
        )
    else:
        root = element.find("ssm:ParameterMapping", NAMESPACES)
    targets: dict[str, list[tuple[str, Any]]] = {}
    for entry in root.iterfind("ssm:MappingEntry", NAMESPACES) if root is not None else ():
        changes = [
            child for child in entry if etree.QName(child).localname.endswith("Transformation")
        ]
        targets.setdefault(entry.get("source"), []).append(
            (entry.get("target"), changes[0] if changes else None)
        )
    return targets


def _transformed(entries: SspEntries, value: Setting, transformation: Any) -> Setting:
    if transformation is None:
        return value
    if etree.QName(transformation).localname != "LinearTransformation" or isinstance(value, str):
        raise InputError(
            "a parameter mapping changes a value; only linear transformations of values without a unit are read",
            entries.file,
        )
    return float(transformation.get("factor", 1.0)) * value + float(
        transformation.get("offset", 0.0)
    )


def _plain(text: str) -> str:
    """A name that may be printed: it does not steer a terminal."""
    return "".join(c if c.isprintable() else "_" for c in text)


def _value(entries: SspEntries, parameter: Any) -> Setting:
    kinds = (parameter.find(f"ssv:{kind}", NAMESPACES) for kind in ("Real", "Float64", "Float32"))
    real = next((kind_element for kind_element in kinds if kind_element is not None), None)
    try:
        value = math.nan if real is None else float(real.get("value"))
    except ValueError:  # SSP 2.0: several, of an array
        value = math.nan
    if real is None or math.isnan(value):
        raise InputError(
            f"parameter '{_plain(parameter.get('name'))}' is no real number", entries.file
        )
    unit = real.get("unit")
    return f"{value!r} {unit}" if unit and unit != "1" else value
