"""The interface of any FMU, read from its model description."""

from __future__ import annotations

import lzma
import math
import re
import zipfile
import zlib
from collections import Counter
from collections.abc import Mapping
from contextlib import ExitStack
from functools import lru_cache
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import iterparse

import fmpy
from fmpy.model_description import ModelDescription, ValidationError

from pam_cosim.errors import InputError
from pam_cosim.files import check_regular
from pam_cosim.model.interface import Interface, Variable, is_sensitivity, sensitivity_name
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
_DESCRIPTION = "modelDescription.xml"
_LONGEST_NAME, _LONGEST_PART = (
    1000,
    200,
)  # letters; systems have 4096 and 255, of which a folder takes some
_LARGEST_REFERENCE = 2**32 - 1
_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,199}")
_KEPT = 128  # descriptions: a diagnosis comes back to those of the catalogue's effects


def read_description(path: Path) -> ModelDescription:
    """FMPy's model description of an FMU of FMI 2.0 or 3.0 for co-simulation or model exchange.

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
    """FMPy's model description of a model-exchange FMU of FMI 2.0 or 3.0.

    Raises:
        InputError: not an FMU, or not of that kind.
    """
    description = _description(path)
    if fmi_version(description) not in ("2.0", "3.0") or description.modelExchange is None:
        kind = "model exchange" if description.modelExchange is not None else "no model exchange"
        raise InputError(
            "the states and their rates are needed, which an FMU of FMI 2.0 or 3.0 shows in model exchange; this is "
            f"FMI {description.fmiVersion} with {kind} (our own FMUs lack it where the model delays a signal)",
            path,
        )
    return description


def has_exchange(path: Path) -> bool:
    """Whether an FMU is for model exchange.

    Raises:
        InputError: not an FMU.
    """
    return _description(path).modelExchange is not None


def has_co_simulation(path: Path) -> bool:
    """Whether an FMU is for co-simulation.

    Raises:
        InputError: not an FMU.
    """
    return _description(path).coSimulation is not None


def _description(path: Path) -> ModelDescription:
    if not Path(path).is_dir():
        check_regular(Path(path))
    file = Path(path).stat()
    return _read(Path(path), file.st_mtime_ns, file.st_size)


@lru_cache(maxsize=_KEPT)
def _read(path: Path, changed: int, size: int) -> ModelDescription:
    """The description of a file as it was at an instant; nobody writes into it."""
    try:
        _check_names(path)
        _check_version_and_indices(path)
        description = fmpy.read_model_description(str(path), validate=False)
        _check_identifiers(description, path)
        _check_numbers(description, path)
        return description
    except InputError:
        raise
    except ValidationError as error:
        raise InputError(f"the FMU is not valid: {error.problems[0]}", path) from error
    except Exception as error:  # fmpy raises bare Exceptions, zipfile, lxml and OS errors
        raise InputError(f"this is not an FMU: {error}", path) from error


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
        parts = entry.filename.split("/")
        odd = {":", "\\"} & {*entry.filename} or not entry.filename.isprintable()
        if odd or parts[0] == "" or ".." in parts:
            raise InputError(
                f"the archive has a file {shown(entry.filename)} that leaves its folder, or whose folders are not "
                "separated by /",
                path,
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
    size = max((one.file_size for one in archive.infolist() if one.filename == name), default=0)
    if size > MOST_OF_DOCUMENT:
        raise InputError(
            f"{shown(name)} in it has {size / 1e6:.0f} MB; {MOST_OF_DOCUMENT / 1e6:.0f} MB can be taken",
            path,
        )


def _check_version_and_indices(path: Path) -> None:
    """Looks at what FMPy takes without a word.

    Raises:
        InputError: a version that it reads otherwise, or not at all; an index of no variable.
    """
    with ExitStack() as opened:
        folder = (
            path if path.is_dir() else zipfile.Path(opened.enter_context(zipfile.ZipFile(path)))
        )
        file = opened.enter_context((folder / _DESCRIPTION).open("rb"))
        elements = (element for _, element in iterparse(file, ("start",)))
        version = str(next(elements).get("fmiVersion"))
        if version[:2] not in ("2.", "3."):
            raise InputError(
                f"an FMU of FMI 2.0 or 3.0 is needed; this is FMI {shown(version)}", path
            )
        count, indices = 0, list[str]()
        for element in elements:
            count += element.tag == "ScalarVariable"
            places = {"Unknown": ("index", "dependencies"), "Real": ("derivative",)}
            for key in places.get(element.tag, ()) if version[0] == "2" else ():
                indices += element.get(key, "").split()
    for index in indices:
        if not (index.isdecimal() and 1 <= int(index[:20]) <= count):
            raise InputError(f"the index {shown(index)} is of none of {count} variables", path)


def _check_identifiers(description: ModelDescription, path: Path) -> None:
    """Looks at what becomes a file's name and what settings are named by.

    Raises:
        InputError: the identifier of a model is none of C, as FMI asks for: it might leave the folder; the name of a
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
    for scalar in real_variables(description):
        for key in ("start", "min", "max", "nominal"):
            _check_number(_attribute(scalar, key), f"{key} of {shown(scalar.name)}", path)


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


def real_variables(description: ModelDescription) -> list[Any]:
    """FMPy's scalar variables of double precision."""
    return [
        v for v in description.modelVariables if v.type in ("Real", "Float64") and not v.dimensions
    ]


def read_interface(path: Path) -> Interface:
    """Names, units and start values of an FMU's real variables.

    ``locals`` holds every other variable that can be read, states, derivatives and calculated parameters included.

    Raises:
        InputError: not an FMU of FMI 2.0 or 3.0.
    """
    return interface_of(read_description(path))


@lru_cache(maxsize=_KEPT)
def interface_of(description: ModelDescription) -> Interface:
    """The interface that a model description declares; nobody writes into it."""
    groups: dict[str, dict[str, Variable]] = {
        "input": {},
        "output": {},
        "parameter": {},
        "local": {},
    }
    for scalar in real_variables(description):
        causality = "local" if scalar.causality == "calculatedParameter" else scalar.causality
        if causality in groups:
            groups[causality][scalar.name] = _variable(scalar)
    experiment = description.defaultExperiment
    given = {}
    if experiment is not None:
        start = float(experiment.startTime or 0.0)
        values = {
            "stop_time": float(experiment.stopTime) - start if experiment.stopTime else None,
            "interval": _float(experiment.stepSize),
            "tolerance": _float(experiment.tolerance),
        }
        given = {key: value for key, value in values.items() if value}
    outputs, parameters = groups["output"], groups["parameter"]
    states = _states(description, groups["local"] | groups["output"])
    by = [*parameters, *states]
    slopes = {sensitivity_name(output, one) for output in outputs for one in by} & {*outputs}
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
    )


def _states(description: ModelDescription, known: Mapping[str, Variable]) -> dict[str, str]:
    """The continuous states that a run can be given other start values of, with their rates; no sensitivities."""
    rates = [unknown.variable for unknown in description.derivatives]
    names = {rate.derivative.name: rate.name for rate in rates if rate.derivative is not None}
    begun = {name for name, variable in known.items() if variable.start is not None}
    return {n: r for n, r in names.items() if n in begun and not is_sensitivity(n)}


def _float(text: Any) -> float | None:
    return None if text is None else float(text)


def _attribute(scalar: Any, name: str) -> Any:
    """An attribute of the variable, or of its declared type."""
    value = getattr(scalar, name)
    if value is None and scalar.declaredType is not None:
        return getattr(scalar.declaredType, name, None)
    return value


def _text(scalar: Any, name: str) -> str:
    """A text that is shown to people; it may be of somebody else."""
    own = getattr(scalar, name) if name == "description" else _attribute(scalar, name)
    return printable(own or "")


def _variable(scalar: Any) -> Variable:
    return Variable(
        name=scalar.name,
        unit=_text(scalar, "unit"),
        description=_text(scalar, "description"),
        start=None if scalar.variability == "constant" else _float(scalar.start),
        min=_float(_attribute(scalar, "min")),
        max=_float(_attribute(scalar, "max")),
        nominal=_float(_attribute(scalar, "nominal")),
        display_unit=_text(scalar, "displayUnit"),
        quantity=_text(scalar, "quantity"),
    )


def feedthrough(path: Path) -> tuple[dict[str, frozenset[str]], bool]:
    """Which inputs each output depends on at once, and whether the model description says so for all of them.

    By FMI an output without a declaration depends on every input.

    Raises:
        InputError: not an FMU of FMI 2.0 or 3.0.
    """
    description = read_description(path)
    inputs = frozenset(v.name for v in real_variables(description) if v.causality == "input")
    outputs = [v.name for v in real_variables(description) if v.causality == "output"]
    declared = {u.variable.name: u.dependencies for u in description.outputs}
    known = {
        name: frozenset(v.name for v in declared[name]) & inputs
        for name in outputs
        if declared.get(name) is not None
    }
    return {name: known.get(name, inputs) for name in outputs}, len(known) == len(
        outputs
    ) or not inputs
