"""A system of FMUs as another tool describes it: an archive of SSP 1.0 or 2.0, ``.ssp``.

What the archive holds is data. Its FMUs are found by name among its entries and written under names of our own, so
nothing in it becomes a path.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pam_cosim.cosimulation.parts import Connection, CoupledFmu, Port, joined
from pam_cosim.cosimulation.ssp_description import Description, Place, Wire, description_of
from pam_cosim.cosimulation.ssp_entries import SspEntries
from pam_cosim.errors import InputError
from pam_cosim.fmu.read import DAMAGED
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.settings import Setting


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


def read_ssp(file: Path, folder: Path, fmu_of: Callable[[str, Path], CoupledFmu]) -> Archive:
    """Reads an archive.

    Args:
        file: the ``.ssp``.
        folder: where its FMUs are unpacked.
        fmu_of: returns the component of a name and an FMU's file.

    Raises:
        InputError: no archive of SSP 1.0 or 2.0, or one with parts that are not FMUs.
    """
    try:
        with zipfile.ZipFile(file) as archive:
            description = description_of(SspEntries(archive, file))
            parts = _unpacked(SspEntries(archive, file), description, folder, fmu_of)
    except (OSError, *DAMAGED) as problem:
        raise InputError(f"this is not an SSP archive: {problem}", file) from problem
    names = {place: _name(place) for place in description.sources}
    try:
        connections = tuple(_connections(description, names, parts))
    except InputError as problem:
        raise InputError(problem.message, file) from problem
    parameters = {
        f"{names[place]}.{name}": value
        for place, name, value in _placed(description, names, file)
        if not _is_default(parts[names[place]].interface.inputs.get(name), value)
    }
    return Archive(parts, connections, parameters, description.title, description.stop_time)


def _unpacked(
    entries: SspEntries,
    description: Description,
    folder: Path,
    fmu_of: Callable[[str, Path], CoupledFmu],
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
            parts[name] = fmu_of(name, files[source])
        except InputError as problem:
            raise InputError(
                f"component '{name}' ({source}): {problem.message}", entries.file
            ) from problem
    return parts


def _name(place: Place) -> str:
    """A component's name without dots, which separate it from its variables."""
    return "_".join(re.sub(r"[^A-Za-z0-9_-]", "_", part) for part in place)


def _connections(
    description: Description, names: dict[Place, str], parts: dict[str, CoupledFmu]
) -> Iterator[Connection]:
    """Those between components, followed through the borders of systems."""
    into: dict[tuple[Place, str], Wire] = {}
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
    source: Port, target: Port, chain: list[Wire], parts: dict[str, CoupledFmu]
) -> Connection:
    if not all(wire.convert for wire in chain):
        parts = {name: _unitless(part) for name, part in parts.items()}
    connection = joined(source, target, parts)
    factor, offset = connection.factor, connection.offset
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


def _is_default(variable: Variable | None, value: Setting) -> bool:
    """Whether an input has this value without being given it."""
    if variable is None or variable.start is None:
        return False
    return value in (variable.start, f"{variable.start!r} {variable.unit}")


def _placed(
    description: Description, names: dict[Place, str], file: Path
) -> Iterator[tuple[Place, str, Setting]]:
    """Parameter values by component; one of a system begins with the names of the elements inside it."""
    values: dict[tuple[Place, str], Setting] = {}
    outermost_last = sorted(description.values, key=lambda entry: -len(entry[0]))  # it wins
    for place, name, value in outermost_last:
        driven = _driven(description, (place, name))
        values |= dict.fromkeys(driven, value)
        if driven:
            continue
        while place in description.systems:
            elements = _elements_of(place, [*names, *description.systems])
            inner = next((p for p in elements if name.startswith(p[-1] + ".")), None)
            if inner is None:
                raise InputError(f"parameter '{name}' is of no component", file)
            place, name = inner, name[len(inner[-1]) + 1 :]
        values[place, name] = value
    for (place, name), value in values.items():
        yield place, name, value


def _driven(description: Description, connector: tuple[Place, str]) -> list[tuple[Place, str]]:
    """The inputs of components that a connector of a system drives, through the borders of systems."""
    reached = [connector]
    for port in reached:
        if port[0] in description.systems:
            wires = [w for w in description.wires if w.start == port]
            ends = [w.end for w in wires if (w.factor, w.offset) == (1.0, 0.0)]
            reached += [end for end in dict.fromkeys(ends) if end not in reached]
    return [port for port in reached if port[0] not in description.systems]


def _elements_of(place: Place, places: Iterable[Place]) -> list[Place]:
    """The elements that stand in a system, without those of the systems in it."""
    return [p for p in places if p and p[:-1] == place]
