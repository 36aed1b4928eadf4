"""A model as data (``fmu/pam_tape.c``): the operations of its functions, and the tables of their operands.

No compiler is needed for it. It gives the numbers of the compiled model to the last bit, somewhat more slowly: it is
for models that are run a few times.
"""

from __future__ import annotations

import json
from collections import Counter, defaultdict
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
from pam_cosim.fmu.read import TABLES

_OPERATIONS = """
OUTPUT ASSIGN ADD SUB MUL DIV NEG EXP LOG POW CONSTPOW SQRT SQ TWICE SIN COS TAN ASIN ACOS ATAN LT LE EQ NE NOT
AND OR FLOOR CEIL FMOD FABS SIGN COPYSIGN IF_ELSE_ZERO ERF FMIN FMAX INV SINH COSH TANH ASINH ACOSH ATANH ATAN2
"""
OPERATIONS = tuple(_OPERATIONS.split())
"""CasADi's operations in the order of ``pam_tape.c``."""
NUMBERS = "tape.bin"
_BATCH, _OPERANDS = 3, 2  # numbers of a batch: operation, count, to; of an operation: a, b
_OUTPUT = OPERATIONS.index("OUTPUT")
_Pair = tuple[int, int]


class NoTapeError(ValueError):
    """A function has an operation that ``pam_tape.c`` lacks."""


@dataclass(frozen=True)
class Tape:
    """One function: operations of one kind after another, so that the kind is looked up once for many.

    Its work space holds the constants, the arguments one after another, and what the operations make.

    Attributes:
        batches: (k, 3) number in ``OPERATIONS``, how many operations, and the place of the first one's result, which
            the others' follow; of outputs the number of the result.
        operands: (n, 2) places of two operands, batch after batch; of an output the operand's place and the element.
        constants: (c,).
        arguments: elements of each argument.
        work: size of the work space.
    """

    batches: NDArray[np.int32]
    operands: NDArray[np.int32]
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
    listed, outputs, numbers = list[_Operation](), defaultdict[int, list[_Pair]](list), _numbers()
    for step in steps:
        if step.operation == ca.OP_CONST:
            place[step.to[0]] = fixed[function.instruction_constant(step.number)]
        elif step.operation == ca.OP_INPUT:
            argument, element = step.of
            place[step.to[0]] = begin[argument] + element
        elif step.operation == ca.OP_OUTPUT:
            result, element = step.to
            outputs[result].append((place[step.of[0]], element))
        elif step.operation in numbers:
            a, b = place[step.of[0]], place[step.of[-1]]
            place[step.to[0]] = begin[-1] + len(listed)
            listed.append(_Operation(numbers[step.operation], a, b))
        else:
            raise NoTapeError(f"{function.name()}: operation {step.operation}")
    batches, operands = _in_batches(listed, outputs, begin[-1])
    return Tape(
        batches,
        operands,
        np.array(constants, dtype=float),
        arguments,
        max(begin[-1] + len(listed), 1),
    )


class _Operation(NamedTuple):
    """Its number in ``OPERATIONS``, and the places of its operands."""

    kind: int
    a: int
    b: int


def _in_batches(
    operations: Sequence[_Operation], outputs: Mapping[int, Sequence[_Pair]], begin: int
) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """Operations of one kind together, each after those that make its operands: ``batches`` and ``operands``.

    Args:
        operations: each after those that make its operands.
        outputs: by the number of the result, places and the elements that they are put to.
        begin: the place of the first operation's result; the others' follow.
    """
    scheduled = _scheduled(operations, begin)
    order = np.array([i for _, members in scheduled for i in members], dtype=int)
    moved = np.arange(begin + len(operations))
    moved[begin + order] = begin + np.arange(len(order))
    batches, to = [], begin
    for kind, members in scheduled:
        batches.append((kind, len(members), to))
        to += len(members)
    batches += [(_OUTPUT, len(elements), result) for result, elements in outputs.items()]
    pairs = [operations[i][1:] for i in order]
    results = [(moved[at], element) for elements in outputs.values() for at, element in elements]
    operands = [*moved[np.array(pairs, dtype=int)].reshape(-1, _OPERANDS), *results]
    return (
        np.array(batches, dtype=np.int32).reshape(-1, _BATCH),
        np.array(operands, dtype=np.int32).reshape(-1, _OPERANDS),
    )


def _scheduled(operations: Sequence[_Operation], begin: int) -> list[tuple[int, list[int]]]:
    """Kinds with the numbers of their operations, in an order in which every operand is made before it is used.

    A list schedule: of the kinds that are ready, one of which nothing is left to come, else the one from which the
    longest chain of operations hangs.
    """
    users: list[list[int]] = [[] for _ in operations]
    missing, chain = [0] * len(operations), [1] * len(operations)
    for i, (_, a, b) in enumerate(operations):
        if a >= begin:
            users[a - begin].append(i)
            missing[i] += 1
        if b >= begin and b != a:
            users[b - begin].append(i)
            missing[i] += 1
    for i in reversed(range(len(operations))):
        if users[i]:
            chain[i] += max(map(chain.__getitem__, users[i]))
    kinds = [operation.kind for operation in operations]
    remaining, order = Counter(kinds), []
    ready, longest = defaultdict[int, list[int]](list), Counter[int]()

    def note(i: int) -> None:
        kind = kinds[i]
        ready[kind].append(i)
        longest[kind] = max(longest[kind], chain[i])

    for i, count in enumerate(missing):
        if not count:
            note(i)
    while ready:
        kind = max(ready, key=lambda k: (len(ready[k]) == remaining[k], longest[k]))
        members = ready.pop(kind)
        for i in members:  # which grows: an operation may use what one of its own kind makes
            for user in users[i]:
                missing[user] -= 1
                if not missing[user]:
                    if kinds[user] == kind:
                        members.append(user)
                    else:
                        note(user)
        remaining[kind] -= len(members)
        longest[kind] = 0
        order.append((kind, members))
    return order


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
    return TapedModel(numbers_of(ode, functions, lean=True) | {"size_w": work}, tapes)


def tape_files(model: TapedModel, guid: str) -> dict[str, bytes]:
    """The model as two files by name."""
    sizes = {
        n: [len(t.batches), len(t.operands), len(t.constants), t.arguments, t.work]
        for n, t in model.tapes.items()
    }
    parts = [
        part.tobytes()
        for t in model.tapes.values()
        for part in (t.constants, t.batches, t.operands)
    ]
    text = json.dumps({"guid": guid, "functions": sizes, **model.tables}, sort_keys=False)
    return {TABLES: text.encode(), NUMBERS: b"".join(parts)}


def read_tapes(folder: Path) -> tuple[dict[str, Any], dict[str, Tape]]:
    """Tables and tapes from a folder that holds the two files."""
    tables = json.loads((folder / TABLES).read_bytes())
    content, at = (folder / NUMBERS).read_bytes(), 0
    tapes = {}
    for name, (batches, operations, constants, arguments, work) in tables["functions"].items():
        numbers = np.frombuffer(content, float, constants, at)
        at += numbers.nbytes
        kinds = np.frombuffer(content, np.int32, batches * _BATCH, at).reshape(-1, _BATCH)
        at += kinds.nbytes
        pairs = np.frombuffer(content, np.int32, operations * _OPERANDS, at).reshape(-1, _OPERANDS)
        at += pairs.nbytes
        tapes[name] = Tape(kinds, pairs, numbers, tuple(arguments), work)
    return tables, tapes


def in_order(tapes: Mapping[str, Tape]) -> Sequence[Tape | None]:
    """The tapes in the order of ``pam_model.h``; None: the model lacks this function."""
    return [tapes.get(name) for name in FUNCTIONS]
