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
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.functions import model_functions
from pam_cosim.fmu.generate import FUNCTIONS, numbers_of

_OPERATIONS = """
OUTPUT ASSIGN ADD SUB MUL DIV NEG EXP LOG POW CONSTPOW SQRT SQ TWICE SIN COS TAN ASIN ACOS ATAN LT LE EQ NE NOT
AND OR FLOOR CEIL FMOD FABS SIGN COPYSIGN IF_ELSE_ZERO ERF FMIN FMAX INV SINH COSH TANH ASINH ACOSH ATANH ATAN2
"""
OPERATIONS = tuple(_OPERATIONS.split())
"""CasADi's operations in the order of ``pam_tape.c``."""
TABLES, NUMBERS = "tape.json", "tape.bin"
_WIDTH = 4  # numbers of an operation: itself, to, a, b
_OUTPUT = OPERATIONS.index("OUTPUT")


class NoTapeError(ValueError):
    """A function has an operation that ``pam_tape.c`` lacks."""


@dataclass(frozen=True)
class Tape:
    """One function.

    Its work space holds the constants, the arguments one after another, and what the operations make.

    Attributes:
        operations: (n, 4) number in ``OPERATIONS``, and the places of the result and of two operands; of an output the
            number of the result, the operand's place, and the element.
        constants: (c,).
        arguments: elements of each argument.
        work: size of the work space.
    """

    operations: NDArray[np.int32]
    constants: Array
    arguments: tuple[int, ...]
    work: int


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
    steps = _steps(function)
    constants = sorted(
        {function.instruction_constant(s.number) for s in steps if s.operation == ca.OP_CONST}
    )
    arguments = tuple(function.numel_in(i) for i in range(function.n_in()))
    begin = np.cumsum([len(constants), *arguments]).tolist()
    fixed, place = {value: i for i, value in enumerate(constants)}, dict[int, int]()
    rows, numbers = [], _numbers()
    for step in steps:
        if step.operation == ca.OP_CONST:
            place[step.to[0]] = fixed[function.instruction_constant(step.number)]
        elif step.operation == ca.OP_INPUT:
            argument, element = step.of
            place[step.to[0]] = begin[argument] + element
        elif step.operation == ca.OP_OUTPUT:
            rows.append((_OUTPUT, step.to[0], place[step.of[0]], step.to[1]))
        elif step.operation in numbers:
            row = (
                numbers[step.operation],
                begin[-1] + step.to[0],
                place[step.of[0]],
                place[step.of[-1]],
            )
            place[step.to[0]] = row[1]
            rows.append(row)
        else:
            raise NoTapeError(f"{function.name()}: operation {step.operation}")
    operations = np.array(rows, dtype=np.int32).reshape(-1, _WIDTH)
    results = max(
        (function.numel_out(i) for i in range(function.n_out())), default=0
    )  # w is looked at there too
    return Tape(
        operations,
        np.array(constants, dtype=float),
        arguments,
        max(begin[-1] + function.sz_w(), results, 1),
    )


class _Step(NamedTuple):
    """An instruction of CasADi's: its number, its operation, and where it takes from and puts to."""

    number: int
    operation: int
    of: Sequence[int]
    to: Sequence[int]


def _steps(function: ca.Function) -> list[_Step]:
    numbers = range(function.n_instructions())
    operations = map(function.instruction_id, numbers)
    sources, places = (
        map(function.instruction_input, numbers),
        map(function.instruction_output, numbers),
    )
    return list(map(_Step, numbers, operations, sources, places))


def taped(ode: Ode) -> TapedModel:
    """A lean model as data.

    Raises:
        ModelError: as ``model_functions``.
        NoTapeError: as ``tape_of``.
    """
    functions = model_functions(ode, lean=True)
    tapes = {f.name(): tape_of(f) for f in functions}
    work = max(tape.work for tape in tapes.values())
    return TapedModel(numbers_of(ode, functions) | {"size_w": work}, tapes)


def tape_files(model: TapedModel, guid: str) -> dict[str, bytes]:
    """The model as two files by name."""
    sizes = {
        n: [len(t.operations), len(t.constants), t.arguments, t.work]
        for n, t in model.tapes.items()
    }
    parts = [
        part
        for t in model.tapes.values()
        for part in (t.constants.tobytes(), t.operations.tobytes())
    ]
    text = json.dumps({"guid": guid, "functions": sizes, **model.tables}, sort_keys=False)
    return {TABLES: text.encode(), NUMBERS: b"".join(parts)}


def read_tapes(folder: Path) -> tuple[dict[str, Any], dict[str, Tape]]:
    """Tables and tapes from a folder that holds the two files."""
    tables = json.loads((folder / TABLES).read_bytes())
    content, at = (folder / NUMBERS).read_bytes(), 0
    tapes = {}
    for name, (operations, constants, arguments, work) in tables["functions"].items():
        numbers = np.frombuffer(content, float, constants, at)
        at += numbers.nbytes
        rows = np.frombuffer(content, np.int32, operations * _WIDTH, at).reshape(-1, _WIDTH)
        at += rows.nbytes
        tapes[name] = Tape(rows, numbers, tuple(arguments), work)
    return tables, tapes


def in_order(tapes: Mapping[str, Tape]) -> Sequence[Tape | None]:
    """The tapes in the order of ``pam_model.h``; None: the model lacks this function."""
    return [tapes.get(name) for name in FUNCTIONS]
