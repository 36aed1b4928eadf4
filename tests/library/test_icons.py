"""Every class has an icon; the benches are diagrams in which everything stands in its own place and lines meet it."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.compiler.syntax import Reference
from pam_cosim.fmu.drawing import Pictures, Placed
from tests.library.catalogue import check_each, tree

PICTURES = Pictures()


def _kind(name: str) -> str:
    info = tree().classes.get(name)
    return "" if info is None else info.kind


CLASSES = [
    n
    for n, c in tree().classes.items()
    if c.kind != "type" and _kind(n.rpartition(".")[0]) in ("", "package")
]
SHAPES = {"Line", "Polygon", "Rectangle", "Ellipse", "Text"}
"""Modelica 3.6, section 18.6.5; without Bitmap, which would need a file."""


def test_every_class_has_an_icon() -> None:
    assert len(CLASSES) > 400
    check_each(_has_icon, CLASSES)


def _has_icon(name: str) -> None:
    kinds = {kind for kind, _ in PICTURES.shapes(PICTURES.of(name))}
    assert kinds and kinds <= SHAPES, kinds


def test_every_connection_is_drawn_from_connector_to_connector() -> None:
    assert sum(len(PICTURES.lines(PICTURES.of(name))) for name in tree().classes) > 200
    check_each(_draws_its_connections, tree().classes)


def _draws_its_connections(name: str) -> None:
    of = PICTURES.of(name)
    parts = {part.name: part for part in PICTURES.parts(of)}
    for connection, line in PICTURES.lines(of):
        between = f"connect({connection.left.text}, {connection.right.text})"
        assert line is not None and line[0] == "Line", between
        points = np.array(line[1]["points"], dtype=float)
        ends = np.array([_place(parts, connection.left), _place(parts, connection.right)])
        assert points[[0, -1]] == pytest.approx(ends, abs=1e-9), between
        assert (np.diff(points, axis=0) == 0).any(axis=1).all(), between  # level or upright


def _place(parts: dict[str, Placed], of: Reference) -> np.ndarray:
    """The middle of a connector of the class itself, or of one of its components."""
    first, *inside = (name for name, _ in of.parts)
    middle = np.zeros((1, 2))
    for connector in inside:
        inner = {part.name: part for part in PICTURES.parts(parts[first].of, layer="Icon")}
        middle = inner[connector].corners.mean(axis=0, keepdims=True)
    place: np.ndarray = parts[first].at(middle)[0]
    return place
