"""Fitted parameters as a file: JSON, or SSV for tools that know the SSP standard."""

from __future__ import annotations

import json
import math
from pathlib import Path
from xml.etree import ElementTree

from pam_cosim.errors import InputError
from pam_cosim.files import write_json, write_text
from pam_cosim.fitting.fit import Fit

_SSV = "http://ssp-standard.org/SSP1/SystemStructureParameterValues"


def write_parameters(path: Path, fit: Fit) -> None:
    """Writes the estimates [SI]; ``.ssv`` gives System Structure Parameter Values 1.0, anything else JSON.

    Raises:
        InputError: the file cannot be written.
    """
    if path.suffix.lower() == ".ssv":
        write_text(path, _ssv(fit))
    else:
        found = {n: e.as_dict() for n, e in fit.parameters.items()}
        write_json(path, {"model": fit.model, "parameters": found})


def _ssv(fit: Fit) -> str:
    ElementTree.register_namespace("ssv", _SSV)
    root = ElementTree.Element(f"{{{_SSV}}}ParameterSet", version="1.0", name=fit.model)
    listed = ElementTree.SubElement(root, f"{{{_SSV}}}Parameters")
    for name, estimate in fit.parameters.items():
        parameter = ElementTree.SubElement(listed, f"{{{_SSV}}}Parameter", name=name)
        ElementTree.SubElement(parameter, f"{{{_SSV}}}Real", value=repr(estimate.value), unit=estimate.unit)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def read_parameters(path: Path) -> dict[str, float]:
    """Reads parameter values [SI] that ``write_parameters`` wrote, or a JSON object of names and numbers.

    Raises:
        InputError: the file is missing or is not such a file.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as problem:
        reason = problem.strerror if isinstance(problem, OSError) else "it is not UTF-8 text"
        raise InputError(f"parameters cannot be read: {reason}", path) from problem
    values = _from_ssv(path, text) if path.suffix.lower() == ".ssv" else _from_json(path, text)
    for name, value in values.items():
        if not math.isfinite(value):
            raise InputError(f"parameter '{name}' is not a finite number", path)
    return values


def _from_json(path: Path, text: str) -> dict[str, float]:
    try:
        content = json.loads(text)
    except json.JSONDecodeError as problem:
        raise InputError(f"not JSON: {problem.msg}", path, problem.lineno, problem.colno) from problem
    found = content.get("parameters", content) if isinstance(content, dict) else None
    if not isinstance(found, dict):
        raise InputError("must hold an object with parameter names and values", path)
    values = {}
    for name, entry in found.items():
        value = entry.get("value") if isinstance(entry, dict) else entry
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise InputError(f"parameter '{name}' has no number as its value", path)
        values[name] = float(value)
    return values


def _from_ssv(path: Path, text: str) -> dict[str, float]:
    try:
        root = ElementTree.fromstring(text)
        return {
            p.attrib["name"]: float(p.find(f"{{{_SSV}}}Real").attrib["value"])  # type: ignore[union-attr]
            for p in root.iter(f"{{{_SSV}}}Parameter")
        }
    except (ElementTree.ParseError, KeyError, ValueError, AttributeError) as problem:
        raise InputError("is not an SSV file with real parameters", path) from problem
