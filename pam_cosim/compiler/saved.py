"""A compiled model as a text, and back: the same expressions, to the last operation."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from typing import Any

import casadi as ca

from pam_cosim.compiler.ode import Delay, Ode, Statement
from pam_cosim.compiler.part import Part
from pam_cosim.model.interface import Interface, Variable

_EXPRESSIONS = ("t", "x", "u", "p", "d", "derivatives", "outputs", "locals", "initial")
_GROUPS = ("inputs", "outputs", "parameters", "locals")


def ode_bytes(ode: Ode) -> bytes:
    """The model without sensitivities (``with_sensitivities`` makes them in a moment)."""
    packer = ca.StringSerializer()
    packer.pack([*(ca.SX(getattr(ode, name)) for name in _EXPRESSIONS), *_further(ode)])
    face = ode.interface
    about = {
        "interface": {
            "model": face.model,
            "stop_time": face.stop_time,
            "interval": face.interval,
            "tolerance": face.tolerance,
            **{group: [_stated(v) for v in getattr(face, group).values()] for group in _GROUPS},
        },
        "states": [_stated(v) for v in ode.states],
        "description": ode.description,
        "delays": [delay.input for delay in ode.delays],
        "parts": [asdict(part) for part in ode.parts],
        "libraries": ode.libraries,
        "resting": ode.resting,
        "following": [name for name, _ in ode.following],
        "statements": [_about_statement(statement) for statement in ode.statements],
        "expressions": packer.encode(),
    }
    return json.dumps(about).encode()


def _about_statement(statement: Statement) -> dict[str, Any]:
    """What a statement says, without its expressions."""
    return {
        "texts": statement.texts,
        "digits": [digits for _, digits in statement.values],
        "error": statement.is_error,
        "start": statement.at_start,
    }


def _further(ode: Ode) -> Iterator[ca.SX]:
    """The expressions of delays, statements and what follows a rest, in the order in which ``read_ode`` takes them."""
    for delay in ode.delays:
        yield ca.SX(delay.time)
    for s in ode.statements:
        yield ca.SX(s.condition)
        yield from (ca.SX(value) for value, _ in s.values)
    for _, value in ode.following:
        yield ca.SX(value)


def _stated(variable: Variable) -> dict[str, Any]:
    """What differs from a variable of which nothing is said."""
    return {key: value for key, value in vars(variable).items() if value not in (None, "")}


def read_ode(content: bytes) -> Ode:
    """The model that ``ode_bytes`` wrote."""
    about = json.loads(content)
    expressions = ca.StringDeserializer(about["expressions"]).unpack()
    further = iter(expressions[len(_EXPRESSIONS) :])
    face = about["interface"]
    groups: dict[str, Any] = {
        group: {v["name"]: Variable(**v) for v in face.pop(group)} for group in _GROUPS
    }
    return Ode(
        interface=Interface(**face, **groups),
        states=tuple(Variable(**v) for v in about["states"]),
        **dict(zip(_EXPRESSIONS, expressions, strict=False)),
        description=about["description"],
        delays=tuple(Delay(number, next(further)) for number in about["delays"]),
        parts=tuple(_part(part) for part in about["parts"]),
        libraries=tuple((name, version) for name, version in about["libraries"]),
        statements=tuple([_statement(s, further) for s in about["statements"]]),
        resting=tuple(about["resting"]),
        following=tuple([(name, next(further)) for name in about["following"]]),
    )


def _part(about: Mapping[str, Any]) -> Part:
    lists = {key: tuple(about[key]) for key in ("bases", "parameters")}
    return Part(**{**about, **lists})


def _statement(about: Mapping[str, Any], further: Iterator[ca.SX]) -> Statement:
    condition = next(further)
    values = tuple((next(further), digits) for digits in about["digits"])
    return Statement(condition, tuple(about["texts"]), values, about["error"], about["start"])
