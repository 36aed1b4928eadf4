"""A compiled model as bytes, and back: the same expressions, to the last operation."""

from __future__ import annotations

import io
import pickle
from typing import Any, cast

import casadi as ca

from pam_cosim.compiler.ode import Ode


class _Writer(pickle.Pickler):
    """Puts expressions aside: CasADi writes them together, with what they share."""

    def __init__(self, file: io.BytesIO) -> None:
        super().__init__(file)
        self.expressions: list[ca.SX] = []

    def persistent_id(self, value: Any) -> int | None:
        """The number of an expression."""
        if not isinstance(value, ca.SX):
            return None
        self.expressions.append(value)
        return len(self.expressions) - 1


class _Reader(pickle.Unpickler):
    def __init__(self, content: bytes, expressions: list[ca.SX]) -> None:
        super().__init__(io.BytesIO(content))
        self._expressions = expressions

    def persistent_load(self, number: Any) -> Any:
        """The expression of a number."""
        return self._expressions[number]


def ode_bytes(ode: Ode) -> bytes:
    """The model without sensitivities (``with_sensitivities`` makes them in a moment)."""
    writer = _Writer(file := io.BytesIO())
    writer.dump(ode)
    packer = ca.StringSerializer()
    packer.pack(writer.expressions)
    return pickle.dumps((packer.encode(), file.getvalue()))


def read_ode(content: bytes) -> Ode:
    """The model that ``ode_bytes`` wrote, which must come from this program: it is not only data."""
    expressions, model = pickle.loads(content)
    return cast(Ode, _Reader(model, ca.StringDeserializer(expressions).unpack()).load())
