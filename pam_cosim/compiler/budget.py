"""How much a compile may take: every limit of the compiler, and what counts against it.

A few lines of Modelica can ask for any amount of work: 2^40 components, an array of a thousand million numbers, a
function that calls itself twice. Each limit is far above what a model of a rig needs and far below what a machine has,
so that its message, with the class and the line, comes within seconds.
"""

from __future__ import annotations

import gc
import math
import sys
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from pam_cosim.errors import ModelError

P = ParamSpec("P")
R = TypeVar("R")


@dataclass(frozen=True)
class CompilerLimits:
    """The limits.

    Attributes:
        file: letters of a Modelica file.
        nesting: of brackets, modifications, blocks and classes within one another in a text.
        depth: of components, values and calls that are evaluated within one another.
        classes: looked up within one another, by inheritance and imports.
        instances: components of a model, elements of arrays among them.
        elements: of one array, and points of one loop.
        steps: of evaluation, elements of arrays among them.
        letters: of a text that is put together.
        unknowns: variables of the system of equations.
        operations: of the equations, as they are put together, differentiated and solved.
        source: letters of the C text of a model; a bench of the library has some 100 000.
        c_seconds: for the C compiler.
        seconds: of processor time of one compile.
        frames: of Python, for what is counted here.
        objects: that are made between two searches for cycles among them.
    """

    file: int = 20_000_000
    nesting: int = 100
    depth: int = 300
    classes: int = 100
    instances: int = 20_000
    elements: int = 100_000
    steps: int = 2_000_000
    letters: int = 100_000
    unknowns: int = 4000
    operations: int = 200_000
    source: int = 2_000_000
    c_seconds: float = 300.0
    seconds: float = 25.0
    frames: int = 8000
    objects: int = 100_000


LIMITS = CompilerLimits()
LARGEST_INTEGER = 2**63 - 1  # Modelica leaves the range to the tool
_LOOK = 1000  # steps between two looks at the clock
DEFECTS = (
    TypeError,
    ValueError,
    LookupError,
    ArithmeticError,
    AttributeError,
    RuntimeError,
    NotImplementedError,
)


_current = threading.local()  # the budget of the running compile


class Budget:
    """What one compile has used. The errors lack a place: the evaluator knows it."""

    def __init__(self) -> None:
        self.steps = self.instances = self.depth = 0
        self._looked = 0
        self._began = time.thread_time()
        _current.budget = self

    def work(self, steps: int = 1) -> None:
        """Counts steps.

        Raises:
            ModelError: it is too much.
        """
        self.steps += steps
        if self.steps > LIMITS.steps:
            raise ModelError(f"the model takes more than {LIMITS.steps} steps to evaluate")
        if self.steps - self._looked > _LOOK:
            self._looked = self.steps
            self.look()

    def look(self) -> None:
        """Looks at the clock.

        Raises:
            ModelError: it took too long.
        """
        if time.thread_time() - self._began > LIMITS.seconds:
            raise ModelError(
                f"the model takes more than {LIMITS.seconds:g} s of processor time to compile"
            )

    def values(self, value: list[Any]) -> list[Any]:
        """An array, whose elements count as steps.

        Raises:
            ModelError: it is too much.
        """
        self.work(_count(value))
        return value

    def instance(self) -> None:
        """Counts a component.

        Raises:
            ModelError: there are too many.
        """
        self.instances += 1
        if self.instances > LIMITS.instances:
            raise ModelError(f"the model has more than {LIMITS.instances} components")
        self.work(10)

    def enter(self, what: str) -> None:
        """Counts a step, and one level more in ``depth``; the caller takes the level back, also after an error.

        Raises:
            ModelError: it is too deep, or too much.
        """
        self.depth += 1
        if self.depth > LIMITS.depth:
            raise ModelError(f"{what} more than {LIMITS.depth} deep within one another")
        self.work()


def checked_size(count: Any) -> int:
    """A number of elements.

    Raises:
        ModelError: it is none, or too large.
    """
    if (
        isinstance(count, bool)
        or not isinstance(count, int | float)
        or not math.isfinite(count)
        or count != int(count)
    ):
        raise ModelError("a size must be an Integer constant")
    if count > LIMITS.elements:
        raise ModelError(f"an array of {count:.6g} elements: there are {LIMITS.elements} at most")
    return max(int(count), 0)


def checked_text(text: str) -> str:
    """A text that was put together.

    Raises:
        ModelError: it is too long.
    """
    if len(text) > LIMITS.letters:
        raise ModelError(f"a String of more than {LIMITS.letters} letters")
    return text


def checked_number(value: Any) -> Any:
    """A number, if it can be kept.

    Raises:
        ModelError: an Integer that is too large.
    """
    if type(value) is int and abs(value) > LARGEST_INTEGER:
        raise ModelError("an Integer beyond 64 bits")
    return value


def check_unknowns(count: int) -> None:
    """Looks at the size of a system of equations.

    Raises:
        ModelError: it is too large.
    """
    if count > LIMITS.unknowns:
        raise ModelError(f"the model has {count} unknowns: there are {LIMITS.unknowns} at most")


def work(steps: int) -> None:
    """Counts steps of the running compile, if any, as ``Budget.work``."""
    if budget := getattr(_current, "budget", None):
        budget.work(steps)


def check_operations(count: int) -> None:
    """Looks at the size of equations, and at the clock.

    Raises:
        ModelError: they are too large, or it took too long.
    """
    if count > LIMITS.operations:
        raise ModelError(
            f"the equations take {count} operations: there are {LIMITS.operations} at most"
        )
    if budget := getattr(_current, "budget", None):
        budget.look()


def check_source(text: str, model: str, states: int) -> None:
    """Looks at the length of the C text of a model.

    Raises:
        ModelError: it is too long for a C compiler.
    """
    if len(text) > LIMITS.source:
        raise ModelError(
            f"{model} is too large: {states} states and {len(text) / 1e6:.1f} MB of C text, of which "
            f"{LIMITS.source / 1e6:.0f} MB can be compiled"
        )


def defect(problem: Exception) -> str:
    """The message on an operation that Python or CasADi refuses."""
    return f"this has no value: {str(problem).strip().splitlines()[-1][:200] if str(problem).strip() else 'it fails'}"


def _count(value: list[Any]) -> int:
    return sum(_count(item) if type(item) is list else 1 for item in value)


@contextmanager
def room() -> Generator[None]:
    """Room on Python's stack for what is counted: each level of Modelica takes some ten of Python's."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, LIMITS.frames))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


@contextmanager
def few_collections() -> Generator[None]:
    """A compile makes hundreds of thousands of objects and keeps them: to look for cycles takes a fifth of its time."""
    before = gc.get_threshold()
    gc.set_threshold(max(before[0], LIMITS.objects) if before[0] else 0, *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)


def bounded(function: Callable[P, R]) -> Callable[P, R]:
    """A function of the compiler with that room; what is nested beyond all counting is an error of the model.

    Raises:
        ModelError: it is.
    """

    @wraps(function)
    def within(*arguments: P.args, **named: P.kwargs) -> R:
        with room(), few_collections():
            try:
                return function(*arguments, **named)
            except RecursionError:
                raise ModelError(
                    "classes, expressions or values are nested without end, or too deeply"
                ) from None
            except MemoryError:
                raise ModelError("the model needs more memory than there is") from None

    return within
