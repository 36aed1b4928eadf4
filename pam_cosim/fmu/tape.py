"""A model as data (``fmu/pam_tape.c``): the operations of its functions, and the tables beside them.

No compiler is needed for it. It gives the numbers of the compiled model to the last bit, more slowly: it is for models
that are run a few times.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.generate import FUNCTIONS, model_functions, numbers_of

OPERATIONS = (
    "CONST", "INPUT", "OUTPUT", "ASSIGN", "ADD", "SUB", "MUL", "DIV", "NEG", "EXP", "LOG", "POW", "CONSTPOW", "SQRT",
    "SQ", "TWICE", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "LT", "LE", "EQ", "NE", "NOT", "AND", "OR", "FLOOR",
    "CEIL", "FMOD", "FABS", "SIGN", "COPYSIGN", "IF_ELSE_ZERO", "ERF", "FMIN", "FMAX", "INV", "SINH", "COSH", "TANH",
    "ASINH", "ACOSH", "ATANH", "ATAN2",
)  # fmt: skip
"""CasADi's operations in the order of ``pam_tape.c``."""
TABLES, NUMBERS = "tape.json", "tape.bin"
_WIDTH = 4  # numbers of an operation: itself, to, a, b
_CONST, _INPUT, _OUTPUT = range(3)


class NoTapeError(ValueError):
    """A function has an operation that ``pam_tape.c`` lacks."""


@dataclass(frozen=True)
class Tape:
    """One function: (n, 4) operations and (c,) constants."""

    operations: NDArray[np.int32]
    constants: Array


@dataclass(frozen=True)
class TapedModel:
    """What ``pam_tape.c`` is given.

    Attributes:
        tables: sizes, names and starts, as ``pam_model.h`` has them.
        tapes: by the function's name; those that a model does not have are missing.
    """

    tables: Mapping[str, Any]
    tapes: Mapping[str, Tape]


@cache
def _numbers() -> dict[int, int]:
    """The number of each of CasADi's operations in ``OPERATIONS``."""
    return {int(getattr(ca, f"OP_{name}")): i for i, name in enumerate(OPERATIONS)}


def tape_of(function: ca.Function) -> Tape:
    """The operations of a function.

    Raises:
        NoTapeError: one of them is not among ``OPERATIONS``.
    """
    numbers, rows = _numbers(), []
    constants: list[float] = []
    for k in range(function.n_instructions()):
        number = numbers.get(function.instruction_id(k))
        if number is None:
            raise NoTapeError(f"{function.name()}: operation {function.instruction_id(k)}")
        if number == _CONST:
            rows.append((number, function.instruction_output(k)[0], len(constants), 0))
            constants.append(function.instruction_constant(k))
            continue
        of, to = function.instruction_input(k), function.instruction_output(k)
        if number == _OUTPUT:
            rows.append((number, to[0], of[0], to[1]))
        else:
            rows.append((number, to[0], of[0], of[-1]))
    return Tape(np.array(rows, dtype=np.int32).reshape(-1, _WIDTH), np.array(constants, dtype=float))


def taped(ode: Ode) -> TapedModel:
    """A lean model as data.

    Raises:
        ModelError: as ``model_functions``.
        NoTapeError: as ``tape_of``.
    """
    functions = model_functions(ode, lean=True)
    return TapedModel(numbers_of(ode, functions), {f.name(): tape_of(f) for f in functions})


def tape_files(model: TapedModel, guid: str) -> dict[str, bytes]:
    """The model as two files by name."""
    sizes = {name: [len(t.operations), len(t.constants)] for name, t in model.tapes.items()}
    parts = [part for t in model.tapes.values() for part in (t.constants.tobytes(), t.operations.tobytes())]
    text = json.dumps({"guid": guid, "functions": sizes, **model.tables}, sort_keys=False)
    return {TABLES: text.encode(), NUMBERS: b"".join(parts)}


def read_tapes(folder: Path) -> tuple[dict[str, Any], dict[str, Tape]]:
    """Tables and tapes from a folder that holds the two files."""
    tables = json.loads((folder / TABLES).read_bytes())
    content, at = (folder / NUMBERS).read_bytes(), 0
    tapes = {}
    for name, (operations, constants) in tables["functions"].items():
        numbers = np.frombuffer(content, float, constants, at)
        at += numbers.nbytes
        rows = np.frombuffer(content, np.int32, operations * _WIDTH, at).reshape(-1, _WIDTH)
        at += rows.nbytes
        tapes[name] = Tape(rows, numbers)
    return tables, tapes


def in_order(tapes: Mapping[str, Tape]) -> Sequence[Tape | None]:
    """The tapes in the order of ``pam_model.h``; None: the model lacks this function."""
    return [tapes.get(name) for name in FUNCTIONS]
