"""A system of FMUs as another tool describes it: an archive of SSP 1.0 or 2.0, ``.ssp``.

What the archive holds is data. Its FMUs are found by name among its entries and written under names of our own, so
nothing in it becomes a path.
"""

from __future__ import annotations

import math
import re
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from lxml import etree

from pam_cosim.cosimulation.parts import Connection, CoupledFmu, Port, joined
from pam_cosim.cosimulation.ssp_entries import SspEntries
from pam_cosim.cosimulation.ssp_names import DESCRIPTION, FMU_TYPE, NAMESPACES
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.model.settings import Setting

_MOST_SYSTEMS = 50  # one inside the other
_Place = tuple[str, ...]  # names of the systems around an element, and its own


@dataclass(frozen=True)
class _Wire:
    """A connection as the archive has it."""

    start: tuple[_Place, str]
    end: tuple[_Place, str]
    factor: float = 1.0
    offset: float = 0.0
    convert: bool = True


@dataclass
class _Description:
    """What an archive's description says."""

    title: str
    stop_time: float | None = None
    sources: dict[_Place, str] = field(default_factory=dict)
    systems: set[_Place] = field(default_factory=set)
    wires: list[_Wire] = field(default_factory=list)
    values: list[tuple[_Place, str, Setting]] = field(default_factory=list)


@dataclass(frozen=True)
class Archive:
    """A system that was read.

    Attributes:
        parts: by name; a component in a system within the system is named ``system_component``.
        connections: between them.
        parameters: by ``component.variable``, with their units.
        title, stop_time: as the description has them, [s].
    """

    parts: dict[str, CoupledFmu]
    connections: tuple[Connection, ...]
    parameters: dict[str, Setting]
    title: str
    stop_time: float | None


def read_ssp(file: Path, folder: Path, made: Callable[[str, Path], CoupledFmu]) -> Archive:
    """Reads an archive.

    Args:
        file: the ``.ssp``.
        folder: where its FMUs are unpacked.
        made: the component of a name and an FMU's file.

    Raises:
        InputError: no archive of SSP 1.0 or 2.0, or one with parts that are not FMUs.
    """
    try:
        with zipfile.ZipFile(file) as archive:
            description = _described(SspEntries(archive, file))
            parts = _unpacked(SspEntries(archive, file), description, folder, made)
    except (OSError, zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError) as problem:
        raise InputError(f"this is not an SSP archive: {problem}", file) from problem
    names = {place: _name(place) for place in description.sources}
    try:
        connections = tuple(_connections(description, names, parts))
    except InputError as problem:
        raise InputError(problem.message, file) from problem
    parameters = {
        f"{names[place]}.{name}": value for place, name, value in _placed(description, names, file)
    }
    return Archive(parts, connections, parameters, description.title, description.stop_time)


def _described(entries: SspEntries) -> _Description:
    root = entries.tree(DESCRIPTION, "the description", "SystemStructureDescription.xsd")
    system = root.find("ssd:System", NAMESPACES)
    experiment = root.find("ssd:DefaultExperiment", NAMESPACES)
    description = _Description(_plain(root.get("name")))
    if experiment is not None and experiment.get("stopTime"):
        begin, end = float(experiment.get("startTime") or 0.0), float(experiment.get("stopTime"))
        description.stop_time = end - begin if math.isfinite(end - begin) and end > begin else None
    _system(entries, system, (), description)
    if not description.sources:
        raise InputError("the system has no components", entries.file)
    return description


def _system(entries: SspEntries, system: Any, place: _Place, description: _Description) -> None:
    if len(place) > _MOST_SYSTEMS:
        raise InputError("systems are nested too deeply", entries.file)
    description.systems.add(place)
    _bindings(entries, system, place, description)
    for element in system.iterfind("ssd:Elements/*", NAMESPACES):
        kind = etree.QName(element).localname
        own = (*place, _plain(str(element.get("name"))))
        if kind == "System":
            _system(entries, element, own, description)
        elif kind != "Component" or element.get("type", FMU_TYPE) != FMU_TYPE:
            raise InputError(
                f"'{'.'.join(own)}' is not an FMU ({_plain(element.get('type', kind))})",
                entries.file,
            )
        elif own in description.sources:
            raise InputError(f"there are two components '{'.'.join(own)}'", entries.file)
        else:
            description.sources[own] = str(element.get("source"))
            _bindings(entries, element, own, description)
    for element in system.iterfind("ssd:Connections/ssd:Connection", NAMESPACES):
        description.wires.append(_wire(entries, element, place))


def _wire(entries: SspEntries, element: Any, place: _Place) -> _Wire:
    def end(which: str) -> tuple[_Place, str]:
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
            return _Wire(end("start"), end("end"), factor, offset, not plain)
        if kind.endswith("Transformation"):
            raise InputError(
                f"a connection has a {kind}; only linear ones of real signals are read",
                entries.file,
            )
    return _Wire(end("start"), end("end"), convert=not plain)


def _bindings(entries: SspEntries, element: Any, place: _Place, description: _Description) -> None:
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
        for one in sets:
            for parameter in one.iterfind("ssv:Parameters/ssv:Parameter", NAMESPACES):
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
    real = next((one for one in kinds if one is not None), None)
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


def _unpacked(
    entries: SspEntries,
    description: _Description,
    folder: Path,
    made: Callable[[str, Path], CoupledFmu],
) -> dict[str, CoupledFmu]:
    parts: dict[str, CoupledFmu] = {}
    files: dict[str, Path] = {}
    for number, (place, source) in enumerate(description.sources.items()):
        name = _name(place)
        if name in parts:
            raise InputError(f"two components would be called '{name}'", entries.file)
        if source not in files:
            files[source] = folder / f"component-{number}.fmu"
            files[source].write_bytes(entries.read(source, f"component '{name}'"))
        try:
            parts[name] = made(name, files[source])
        except InputError as problem:
            raise InputError(
                f"component '{name}' ({source}): {problem.message}", entries.file
            ) from problem
    return parts


def _name(place: _Place) -> str:
    """A component's name without dots, which separate it from its variables."""
    return "_".join(re.sub(r"[^A-Za-z0-9_-]", "_", one) for one in place)


def _connections(
    description: _Description, names: dict[_Place, str], parts: dict[str, CoupledFmu]
) -> Iterator[Connection]:
    """Those between components, followed through the borders of systems."""
    into: dict[tuple[_Place, str], _Wire] = {}
    for wire in description.wires:
        if wire.end in into:
            raise InputError(f"two connections end at '{'.'.join((*wire.end[0], wire.end[1]))}'")
        into[wire.end] = wire
    systems = description.systems
    for wire in description.wires:
        place, variable = wire.end
        if place in systems:
            continue
        chain = [wire]
        while (
            chain[-1].start[0] in systems
            and chain[-1].start in into
            and len(chain) <= len(description.wires)
        ):
            chain.append(into[chain[-1].start])
        start, output = chain[-1].start
        if start in systems:
            continue  # an input of the whole system: it stays free
        if start not in names or place not in names:
            missing = start if start not in names else place
            raise InputError(f"a connection names '{'.'.join(missing)}', which is no component")
        yield _joined(Port(names[start], output), Port(names[place], variable), chain, parts)


def _joined(
    source: Port, target: Port, chain: list[_Wire], parts: dict[str, CoupledFmu]
) -> Connection:
    plain = not all(wire.convert for wire in chain)
    whole = joined(
        source, target, {name: _unitless(part) for name, part in parts.items()} if plain else parts
    )
    factor, offset = whole.factor, whole.offset
    for wire in reversed(chain):
        factor, offset = wire.factor * factor, wire.factor * offset + wire.offset
    return Connection(source, target, factor, offset)


def _unitless(part: CoupledFmu) -> CoupledFmu:
    from dataclasses import replace

    def plain(variables: dict[str, Any]) -> dict[str, Any]:
        return {name: replace(variable, unit="") for name, variable in variables.items()}

    interface = part.interface
    return replace(
        part,
        interface=Interface(interface.model, plain(interface.inputs), plain(interface.outputs)),
    )


def _placed(
    description: _Description, names: dict[_Place, str], file: Path
) -> Iterator[tuple[_Place, str, Setting]]:
    """Parameter values by component; one of a system begins with the names of the elements inside it."""
    values: dict[tuple[_Place, str], Setting] = {}
    for place, name, value in sorted(
        description.values, key=lambda one: -len(one[0])
    ):  # the outermost wins
        while place in description.systems:
            fit = [
                p
                for p in (*names, *description.systems)
                if len(p) == len(place) + 1 and p[:-1] == place
            ]
            inner = next((p for p in fit if name.startswith(p[-1] + ".")), None)
            if inner is None:
                raise InputError(f"parameter '{name}' is of no component", file)
            place, name = inner, name[len(inner[-1]) + 1 :]
        values[place, name] = value
    for (place, name), value in values.items():
        yield place, name, value
