"""The interface of any FMU, read from its model description."""

from __future__ import annotations

import lzma
import math
import re
import zipfile
import zlib
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

from pam_cosim.errors import InputError
from pam_cosim.files import check_regular
from pam_cosim.fmu.description_file import DefaultExperiment, ModelDescription, ModelVariable, parse
from pam_cosim.model.interface import (
    Interface,
    Kind,
    Pressures,
    Variable,
    is_sensitivity,
    sensitivity_name,
)
from pam_cosim.wording import printable, shown

MOST_BYTES = 2_000_000_000  # of all files of an archive, unpacked
MOST_OF_DOCUMENT = 20_000_000  # bytes of XML; parsed, they take thirty times as many
DAMAGED = (
    zipfile.BadZipFile,
    NotImplementedError,
    RuntimeError,
    EOFError,
    UnicodeDecodeError,
    zlib.error,
    lzma.LZMAError,
)  # what reading an archive raises that is none, or not whole
TABLES = "tape.json"  # in the folder of a model as data
TOOL = "pam-cosim"  # in the attribute of the tool that made an FMU
_DESCRIPTION = "modelDescription.xml"
_LONGEST_NAME, _LONGEST_PART = (
    1000,
    200,
)  # letters; systems have 4096 and 255, of which a folder takes some
_LARGEST_REFERENCE = 2**32 - 1
_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,199}")
_KINDS: dict[str, Kind] = {
    **dict.fromkeys(("Real", "Float64", "Float32"), "Real"),
    **dict.fromkeys(
        ("Integer", *(f"{u}Int{n}" for u in ("", "U") for n in (8, 16, 32, 64))), "Integer"
    ),
    "Boolean": "Boolean",
    "Enumeration": "Enumeration",
    "String": "String",
}
_MOST_ELEMENTS = 10_000  # of an array
_MOST_ROWS = 100_000  # of a run without a declared interval, up to which it is the usual one
_KEPT = 128  # descriptions: a diagnosis comes back to those of the catalogue's effects


def read_description(path: Path) -> ModelDescription:
    """The model description of an FMU of FMI 2.0 or 3.0 for co-simulation or model exchange.

    Raises:
        InputError: not an FMU, or not of that kind.
    """
    description = _description(path)
    runs = description.coSimulation is not None or description.modelExchange is not None
    if fmi_version(description) not in ("2.0", "3.0") or not runs:
        kind = "" if runs else " with neither co-simulation nor model exchange"
        raise InputError(
            f"an FMU of FMI 2.0 or 3.0 is needed; this is FMI {description.fmiVersion}{kind}", path
        )
    return description


def exchange_description(path: Path) -> ModelDescription:
    """The same, of an FMU that has model exchange.

    Raises:
        InputError: not an FMU, or not of that kind.
    """
    description = read_description(path)
    if description.modelExchange is None:
        raise InputError(
            "the states and their rates are needed, which an FMU shows in model exchange; this one has none (our own "
            "FMUs lack it where the model delays a signal)",
            path,
        )
    return description


def _description(path: Path) -> ModelDescription:
    if not Path(path).is_dir():
        check_regular(Path(path))
    file = Path(path).stat()
    return _read(Path(path), file.st_mtime_ns, file.st_size)


@lru_cache(maxsize=_KEPT)
def _read(path: Path, changed: int, size: int) -> ModelDescription:
    """The description of a file as it was at an instant; it must not be changed."""
    try:
        _check_names(path)
        description = _parsed(path)
        _check_identifiers(description, path)
        _check_numbers(description, path)
        return description
    except InputError as problem:
        problem.file = problem.file or path
        raise
    except Exception as error:  # of zipfile, the parser of XML, numbers and the system
        raise InputError(f"this is not an FMU: {error}", path) from error


def _parsed(path: Path) -> ModelDescription:
    if path.is_dir():
        with (path / _DESCRIPTION).open("rb") as file:
            return parse(file)
    with zipfile.ZipFile(path) as archive, archive.open(_DESCRIPTION) as entry:
        return parse(entry)


def _check_names(path: Path) -> None:
    """Looks at the names in an archive, which become files, and at the size of its description.

    Raises:
        InputError: one that cannot, or must not; a description that is too large.
    """
    if path.is_dir():
        if (path / _DESCRIPTION).exists():
            check_regular(path / _DESCRIPTION, MOST_OF_DOCUMENT)
        return
    with zipfile.ZipFile(path) as archive:
        entries = archive.infolist()
        check_document(archive, _DESCRIPTION, path)
    if sum(entry.filename == _DESCRIPTION for entry in entries) > 1:
        raise InputError(f"the archive has two files {shown(_DESCRIPTION)}", path)
    for entry in entries:
        parts = re.split(r"[/\\]", entry.filename)
        odd = ":" in entry.filename or not entry.filename.isprintable()
        if odd or parts[0] == "" or ".." in parts:
            raise InputError(
                f"the archive has a file {shown(entry.filename)} that leaves its folder", path
            )
        if len(entry.filename) > _LONGEST_NAME or max(map(len, parts)) > _LONGEST_PART:
            raise InputError(
                f"the archive has a file whose name is too long: {shown(entry.filename)}", path
            )
    if sum(entry.file_size for entry in entries) > MOST_BYTES:
        raise InputError(f"the archive holds more than {MOST_BYTES / 1e9:g} GB", path)


def check_document(archive: zipfile.ZipFile, name: str, path: Path) -> None:
    """Looks at the size of a document of XML in an archive, before it is parsed.

    Args:
        archive: that is open.
        name: of the document in it.
        path: the archive's file.

    Raises:
        InputError: it is too large.
    """
    size = max(
        (entry.file_size for entry in archive.infolist() if entry.filename == name), default=0
    )
    if size > MOST_OF_DOCUMENT:
        raise InputError(
            f"{shown(name)} in it has {size / 1e6:.0f} MB; {MOST_OF_DOCUMENT / 1e6:.0f} MB can be taken",
            path,
        )


def _check_identifiers(description: ModelDescription, path: Path) -> None:
    """Looks at what becomes a file's name and what settings are named by.

    Raises:
        InputError: the identifier of a model is none of C, as FMI requires: it might leave the folder; the name of a
            variable holds what is not visible.
    """
    for kind in (description.coSimulation, description.modelExchange):
        if kind is not None and not _IDENTIFIER.fullmatch(str(kind.modelIdentifier)):
            raise InputError(
                f"the model identifier {shown(kind.modelIdentifier)} is no identifier of C: as a file's name it may "
                "be one that leaves its folder",
                path,
            )
    for scalar in description.modelVariables:
        if not str(scalar.name).isprintable():
            raise InputError(f"the name {shown(scalar.name)} holds what is not visible", path)
    names = Counter(str(scalar.name) for scalar in description.modelVariables)
    for name, count in names.items():
        if count > 1:
            raise InputError(
                f"{count} variables have the name {shown(name)}; each must have a name of its own",
                path,
            )


def _check_numbers(description: ModelDescription, path: Path) -> None:
    """Looks at what must be a number in a description.

    Raises:
        InputError: it is none.
    """
    experiment = description.defaultExperiment
    for key in ("startTime", "stopTime", "stepSize", "tolerance"):
        if experiment is not None:
            _check_number(getattr(experiment, key), f"{key} of its default experiment", path)
    for scalar in description.modelVariables:
        reference = scalar.valueReference
        if reference is not None and not 0 <= int(reference) <= _LARGEST_REFERENCE:
            raise InputError(
                f"the value reference {reference} of {shown(scalar.name)} is beyond 32 bits", path
            )
    for scalar in description.modelVariables:
        if _KINDS.get(scalar.type) not in ("Real", "Integer", "Enumeration"):
            continue
        for key in ("start", "min", "max", "nominal"):
            for text in _numbers(_attribute(scalar, key)):
                _check_number(text, f"{key} of {shown(scalar.name)}", path)


def _numbers(given: Any) -> list[Any]:
    """The numbers of an attribute, of which an array has several."""
    return given.split() if isinstance(given, str) else [given]


def _check_number(text: Any, what: str, path: Path) -> None:
    try:
        wrong = text is not None and math.isnan(float(text))
    except (TypeError, ValueError):
        wrong = True
    if wrong:
        raise InputError(
            f"the description is not valid: {what} is {shown(text)}, which is no number", path
        )


def fmi_version(description: ModelDescription) -> str:
    """Major and minor version of FMI: "2.0", "3.0"; maintenance releases are compatible."""
    return ".".join(str(description.fmiVersion).split("-")[0].split(".")[:2])


def is_own(description: ModelDescription) -> bool:
    """Whether an FMU says that this program made it."""
    return str(description.generationTool).startswith(TOOL)


class Slot(NamedTuple):
    """Where the value of a variable is in an FMU: an array has one value reference for all its elements.

    Attributes:
        scalar: the variable in the model description.
        name: of the variable, or of the element: ``a[1,2]``.
        place, size: which element it is, from 0, and how many there are.
        starts: start values of all elements; a String has a text.
    """

    scalar: ModelVariable
    name: str
    place: int
    size: int
    starts: tuple[float | str | None, ...]

    @property
    def kind(self) -> Kind:
        """Type of the values."""
        return _KINDS[self.scalar.type]


@lru_cache(maxsize=_KEPT)
def slots(description: ModelDescription) -> Mapping[str, Slot]:
    """By name, each variable of a type that has numbers or texts, and each element of an array."""
    return {
        slot.name: slot
        for scalar in description.modelVariables
        if scalar.type in _KINDS and _size(scalar) <= _MOST_ELEMENTS
        for slot in _slots_of(scalar)
    }


def _size(scalar: ModelVariable) -> int:
    return math.prod(scalar.shape or ())


def _slots_of(scalar: ModelVariable) -> Iterator[Slot]:
    starts, size = _starts(scalar, _size(scalar)), _size(scalar)
    if not scalar.shape:
        yield Slot(scalar, scalar.name, 0, 1, starts)
        return
    places = product(*(range(1, count + 1) for count in scalar.shape))
    for place, indices in enumerate(places):
        name = f"{scalar.name}[{','.join(map(str, indices))}]"
        yield Slot(scalar, name, place, size, starts)


def _starts(scalar: ModelVariable, size: int) -> tuple[float | str | None, ...]:
    """Of every element: numbers stand in one text, and Strings in a list where there are several."""
    given = None if scalar.variability == "constant" else scalar.start
    if given is None:
        return (None,) * size
    texts = [given] if isinstance(given, str) else given
    read: list[float | str]
    if scalar.type == "String":
        read = [*map(str, texts)]
    else:
        read = [_start(word) for text in texts for word in str(text).split()]
    return tuple(read[i % len(read)] for i in range(size)) if read else (None,) * size


def _start(text: Any) -> float:
    word = str(text).casefold()
    return float(word == "true") if word in ("true", "false") else float(text)


def read_interface(path: Path) -> Interface:
    """Names, units and start values of an FMU's variables; the elements of an array are variables.

    ``locals`` holds every other variable that can be read, states, derivatives and calculated parameters included.

    Raises:
        InputError: not an FMU of FMI 2.0 or 3.0.
    """
    return interface_of(read_description(path))


@lru_cache(maxsize=_KEPT)
def interface_of(description: ModelDescription) -> Interface:
    """The interface that a model description declares; it must not be changed."""
    groups: dict[str, dict[str, Variable]] = {
        "input": {},
        "output": {},
        "parameter": {},
        "local": {},
    }
    refused: dict[str, str] = {}
    calculated: list[str] = []
    slots_by_name = slots(description)
    pressures: Pressures = "gauge" if is_own(description) else ""
    for name, slot in slots_by_name.items():
        causality = slot.scalar.causality
        if causality == "calculatedParameter":
            calculated.append(name)
            causality = "local"
        reason = _refusal(slot)
        if reason:
            refused[name] = reason
        elif causality in groups:
            groups[causality][name] = _variable(slot, pressures)
    for scalar in description.modelVariables:
        if scalar.name not in slots_by_name and not scalar.shape:
            refused[scalar.name] = f"it is of type {scalar.type}, which has no number"
        elif scalar.shape:
            first = f"{scalar.name}[{','.join('1' * len(scalar.shape))}]"
            shape = " by ".join(map(str, scalar.shape))
            refused[scalar.name] = f"it is an array of {shape} elements; name one, as {first}"
            if first not in slots_by_name:
                refused[scalar.name] = f"it is an array of {shape} elements of {scalar.type}"
    experiment = description.defaultExperiment
    given = {} if experiment is None else _experiment(experiment)
    outputs, parameters = groups["output"], groups["parameter"]
    states = _states(description, groups["local"] | groups["output"])
    by = [*parameters, *states]
    slopes = {sensitivity_name(output, parameter) for output in outputs for parameter in by} & {
        *outputs
    }
    return Interface(
        printable(description.modelName or ""),
        groups["input"],
        {n: v for n, v in outputs.items() if n not in slopes},
        parameters,
        groups["local"],
        **given,
        sensitivities={n: v for n, v in outputs.items() if n in slopes},
        states=tuple(states),
        rates=tuple(states.values()),
        refused=refused,
        calculated=tuple(calculated),
    )


def _experiment(experiment: DefaultExperiment) -> dict[str, float]:
    """Default times of runs; an interval that is not declared fits the duration."""
    start, stop = float(experiment.startTime or 0.0), _float(experiment.stopTime)
    duration = None if stop is None else stop - start
    interval = _float(experiment.stepSize)
    if (
        not interval
        and duration
        and not duration / _MOST_ROWS <= Interface.interval <= duration / 10
    ):
        interval = duration / 1000
    values = {
        "start_time": start,
        "stop_time": duration,
        "interval": interval,
        "tolerance": _float(experiment.tolerance),
    }
    return {key: value for key, value in values.items() if value}


def _refusal(slot: Slot) -> str:
    """Why a variable is neither set nor read; "" where it can be."""
    causality = slot.scalar.causality
    if causality == "independent":
        return "it is the time"
    if causality == "structuralParameter":
        start = slot.starts[0]
        return f"it is a structural parameter, which sets sizes of arrays, and stays {start:g}"
    if slot.kind == "String" and causality != "parameter":
        return f"it is a String and an {causality}, which has no trajectory"
    return ""


def _states(description: ModelDescription, variables: Mapping[str, Variable]) -> dict[str, str]:
    """The continuous states that a run can be given other start values of, with their rates; no sensitivities."""
    rates = dict(state_names(description))
    names = {state: rate for state, rate in rates.items() if state in variables}
    begun = {name for name, variable in variables.items() if variable.start is not None}
    return {n: r for n, r in names.items() if n in begun and not is_sensitivity(n)}


def fixed_step(description: ModelDescription) -> float | None:
    """The step of communication that an FMU declares [s]; None: none."""
    experiment = description.defaultExperiment
    declared = getattr(description.coSimulation, "fixedInternalStepSize", None)
    return _float(declared or (experiment.stepSize if experiment is not None else None)) or None


def state_names(description: ModelDescription) -> Iterator[tuple[str, str]]:
    """Names of the continuous states and of their derivatives by time, in the FMU's order; of arrays the elements."""
    for unknown in description.derivatives:
        rate = unknown.variable
        if rate.derivative is not None:
            states, rates = _slots_of(rate.derivative), _slots_of(rate)
            yield from zip((s.name for s in states), (r.name for r in rates), strict=False)


def _float(text: Any) -> float | None:
    return None if text is None else float(text)


def _attribute(scalar: ModelVariable, name: str) -> Any:
    """An attribute of the variable, or of its declared type."""
    value = getattr(scalar, name)
    if value is None and scalar.declaredType is not None:
        return getattr(scalar.declaredType, name, None)
    return value


def _text(scalar: ModelVariable, name: str) -> str:
    """A text that is shown to people; it may come from another tool."""
    text = getattr(scalar, name) if name == "description" else _attribute(scalar, name)
    return printable(text or "")


def _variable(slot: Slot, pressures: Pressures) -> Variable:
    scalar, start = slot.scalar, slot.starts[slot.place]
    least, greatest, nominal = (
        _numbers(_attribute(scalar, key)) for key in ("min", "max", "nominal")
    )
    declared = scalar.declaredType
    items = declared.items if declared and slot.kind == "Enumeration" else None
    span = integer_span(scalar.type) if slot.kind == "Integer" else None
    return Variable(
        name=slot.name,
        unit=_text(scalar, "unit"),
        description=_text(scalar, "description"),
        start=start if isinstance(start, float) else None,
        min=_float(least[slot.place % len(least)]),
        max=_float(greatest[slot.place % len(greatest)]),
        nominal=_float(nominal[slot.place % len(nominal)]),
        display_unit=_text(scalar, "displayUnit"),
        quantity=_text(scalar, "quantity"),
        kind=slot.kind,
        items={printable(item): float(number) for item, number in items} if items else None,
        text=start if isinstance(start, str) else "",
        span=span,
        is_discrete=slot.kind != "Real" or scalar.variability == "discrete",
        pressures=pressures,
    )


def integer_span(kind: str) -> tuple[int, int]:
    """The least and the greatest number of a type of integers, such as "UInt8"; "Integer" has 32 bits."""
    sign, _, bits = kind.partition("Int")
    count = 2 ** int(bits if bits.isdecimal() else 32)
    return (0, count - 1) if sign == "U" else (-(count // 2), count // 2 - 1)


def feedthrough(path: Path) -> tuple[dict[str, frozenset[str]], bool]:
    """Which inputs each output depends on at once, and whether the model description states so for all of them.

    By FMI an output without a declaration depends on every input.

    Raises:
        InputError: not an FMU of FMI 2.0 or 3.0.
    """
    description = read_description(path)
    interface, by_name = interface_of(description), slots(description)
    inputs, outputs = frozenset(interface.inputs), [*interface.outputs, *interface.sensitivities]
    declared = {u.variable.name: u.dependencies for u in description.outputs}
    sources_by_output = {}
    for name in outputs:
        dependencies = declared.get(by_name[name].scalar.name)
        if dependencies is not None:
            sources = {v.name for v in dependencies}
            sources_by_output[name] = frozenset(
                i for i in inputs if by_name[i].scalar.name in sources
            )
    return {name: sources_by_output.get(name, inputs) for name in outputs}, len(
        sources_by_output
    ) == len(outputs) or not inputs
