"""Fitted parameters as a file: JSON, or SSV for tools that know the SSP standard."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from pam_cosim.errors import InputError
from pam_cosim.files import MOST_TEXT, read_file, read_json, write_json, write_text
from pam_cosim.fitting.fit import Fit
from pam_cosim.units import BaseUnit, UnitError, base_unit
from pam_cosim.wording import shown

_SSC = "http://ssp-standard.org/SSP1/SystemStructureCommon"
_SSV = "http://ssp-standard.org/SSP1/SystemStructureParameterValues"
_OTHER_FILES = (
    ".mo",
    ".fmu",
    ".csv",
    ".npz",
    ".html",
    ".png",
    ".toml",
)  # what other commands write
_REALS = tuple(
    f"{{{_SSV}}}{kind}" for kind in ("Real", "Float64", "Float32")
)  # SSP 1.0, and 2.0 as well


def check_parameter_file(path: Path) -> None:
    """Finds out that a name is not one of something else than parameters.

    Raises:
        InputError: it is.
    """
    if path.suffix.lower() in _OTHER_FILES:
        message = "parameters are written as .json or .ssv; 'pam-cosim add --from' writes a model that has them"
        raise InputError(message, path)


def write_parameters(path: Path, fit: Fit) -> None:
    """Writes the estimates [SI]; ``.ssv`` gives System Structure Parameter Values 1.0, else JSON.

    A model has no place for what is of one run alone: an ``.ssv`` file holds the shared parameters.

    Raises:
        InputError: the file cannot be written, or its name is one of something else.
    """
    check_parameter_file(path)
    if path.suffix.lower() == ".ssv":
        write_text(path, _ssv(fit))
    else:
        write_json(path, {"model": fit.model, "parameters": fit.parameters})


def _ssv(fit: Fit) -> str:
    """System Structure Parameter Values 1.0."""
    shared = {name: estimate for name, estimate in fit.parameters.items() if not estimate.run}
    ElementTree.register_namespace("ssv", _SSV)
    ElementTree.register_namespace("ssc", _SSC)
    root = ElementTree.Element(f"{{{_SSV}}}ParameterSet", version="1.0", name=fit.model)
    listed = ElementTree.SubElement(root, f"{{{_SSV}}}Parameters")
    units_by_name = {
        text: _definition(text)
        for text in dict.fromkeys(estimate.unit for estimate in shared.values() if estimate.unit)
    }
    defined = [unit for unit in units_by_name.values() if unit is not None]
    for name, estimate in shared.items():
        parameter = ElementTree.SubElement(listed, f"{{{_SSV}}}Parameter", name=name)
        ElementTree.SubElement(
            parameter,
            f"{{{_SSV}}}Real",
            {"value": repr(estimate.value)}
            | ({"unit": estimate.unit} if units_by_name.get(estimate.unit) else {}),
        )
    units = ElementTree.SubElement(root, f"{{{_SSV}}}Units") if defined else root
    for unit in defined:  # a parameter may only refer to a unit that the file defines
        base = {name: str(exponent) for name, exponent in unit.exponents}
        base |= {"factor": repr(unit.factor)} if unit.factor != 1 else {}
        base |= {"offset": repr(unit.offset)} if unit.offset != 0 else {}
        definition = ElementTree.SubElement(units, f"{{{_SSC}}}Unit", name=unit.name)
        ElementTree.SubElement(definition, f"{{{_SSC}}}BaseUnit", base)
    ElementTree.indent(root)
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        + ElementTree.tostring(root, encoding="unicode")
        + "\n"
    )


def _definition(unit: str) -> BaseUnit | None:
    """A unit by SI base units; None: an FMU of another tool may have an unknown unit."""
    try:
        return base_unit(unit)
    except UnitError:
        return None


def read_parameters(path: Path) -> dict[str, float]:
    """Reads parameter values [SI] that ``write_parameters`` wrote, or a JSON object of names and numbers.

    Raises:
        InputError: the file is missing or is not such a file.
    """
    return (
        _from_ssv(path) if path.suffix.lower() == ".ssv" else parameters_in(read_json(path), path)
    )


def parameters_in(content: Any, path: Path) -> dict[str, float]:
    """The parameters [SI] in a JSON document: of a fit, of the model that a diagnosis came to, or names and numbers.

    Raises:
        InputError: it holds no such thing; names ``path``.
    """
    holder = content.get("final", content) if isinstance(content, dict) else None
    parameters = holder.get("parameters", holder) if isinstance(holder, dict) else None
    if not isinstance(parameters, dict) or content == {}:
        raise InputError("must hold an object with parameter names and values", path)
    return {name: _number(name, entry, path) for name, entry in parameters.items()}


def units_in(content: Any) -> dict[str, str]:
    """Units of the parameters in a JSON document, those that it names."""
    holder = content.get("final", content)
    entries = holder.get("parameters", holder).items()
    return {
        name: str(entry["unit"])
        for name, entry in entries
        if isinstance(entry, dict) and "unit" in entry
    }


def _number(name: str, entry: Any, path: Path) -> float:
    value = entry.get("value") if isinstance(entry, dict) else entry
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(
            f"parameter {shown(name)} has no number as its value; this is no file of parameters",
            path,
        )
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(f"parameter {shown(name)} is not a finite number", path)
    return number


def _from_ssv(path: Path) -> dict[str, float]:
    try:
        root = ElementTree.fromstring(read_file(path, MOST_TEXT))
        values = {
            p.attrib["name"]: float(
                next(child for child in p if child.tag in _REALS).attrib["value"]
            )
            for p in root.iter(f"{{{_SSV}}}Parameter")
        }
    except OSError as problem:
        raise InputError(f"cannot be read: {problem.strerror}", path) from problem
    except (ElementTree.ParseError, LookupError, ValueError, StopIteration) as problem:
        raise InputError("is not an SSV file with real parameters", path) from problem
    return {name: _number(name, value, path) for name, value in values.items()}
