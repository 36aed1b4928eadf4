"""Draws icons and diagrams of Modelica classes from their annotations (Modelica 3.6, chapter 18)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import patches
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pam_cosim.compiler.expression_parser import ExpressionParser
from pam_cosim.compiler.instance import Class
from pam_cosim.compiler.lexer import tokenise
from pam_cosim.compiler.library import Library
from pam_cosim.compiler.lookup import Lookup
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import (
    EMPTY,
    Array,
    Call,
    ComponentDeclaration,
    Connect,
    Equation,
    Expression,
    For,
    Literal,
    Modification,
    Reference,
    Unary,
)
from pam_cosim.errors import ModelError
from pam_cosim.resources import modelica_root

Shape = tuple[str, dict[str, Any]]
Points = np.ndarray
Map = Callable[[Points], Points]

DRAWN = ("model", "block", "connector")
"""Kinds of classes whose components have an icon."""
SQUARE = ((-100.0, -100.0), (100.0, 100.0))


@dataclass(frozen=True)
class Placed:
    """A component in a diagram: where it stands and the class that it shows."""

    name: str
    of: Class
    extent: Points
    origin: Points
    rotation: float

    @property
    def corners(self) -> Points:
        """The least and the largest x and y, (2, 2)."""
        ends = self.at(np.array(SQUARE))
        return np.array([ends.min(axis=0), ends.max(axis=0)])

    def at(self, points: Points) -> Points:
        """Points (n, 2) of the icon as points of the diagram."""
        first, second = self.extent
        x, y = ((first + second) / 2 + points / 200 * (second - first)).T
        c, s = np.cos(np.radians(self.rotation)), np.sin(np.radians(self.rotation))
        placed: Points = self.origin + np.stack([c * x - s * y, s * x + c * y], axis=-1)
        return placed


class Pictures:
    """The drawing annotations of a library."""

    def __init__(self, files: Sequence[Path] = ()) -> None:
        self.library = Library(modelica_root(), files)
        self.lookup = Lookup(self.library)

    def of(self, name: str) -> Class:
        """The class of a full name."""
        named = self.lookup.qualified(name)
        if named is None:
            raise ModelError(f"there is no class '{name}'{self.library.similar(name)}")
        return named

    def shapes(self, of: Class, layer: str = "Icon") -> list[Shape]:
        """Shapes of a layer, those of base classes first, as an editor draws them."""
        inherited = [shape for base in self.lookup.bases(of) for shape in self.shapes(base, layer)]
        graphics = _argument(of.definition.annotation, layer, "graphics")
        return inherited + (value(graphics) if graphics is not None else [])

    def extent(self, of: Class) -> Points:
        """Corners of the diagram, (2, 2): its own, else those of the first base class that states some."""
        stated = self._stated_extent(of)
        return np.array(SQUARE if stated is None else value(stated), dtype=float)

    def _stated_extent(self, of: Class) -> Expression | None:
        written = _argument(of.definition.annotation, "Diagram", "coordinateSystem", "extent")
        inherited = (self._stated_extent(base) for base in self.lookup.bases(of))
        return written or next((extent for extent in inherited if extent is not None), None)

    def parts(
        self, of: Class, unplaced: list[str] | None = None, layer: str = "Diagram"
    ) -> list[Placed]:
        """Components with a Placement, inherited ones first, where they stand in the diagram or in the icon.

        Names of models, blocks and connectors without one go to a list; not those of ``outer`` ones, which refer to a
        component of an enclosing class.
        """
        parts = [
            part for base in self.lookup.bases(of) for part in self.parts(base, unplaced, layer)
        ]
        for component in of.definition.components.values():
            kind = self.lookup.find(self.lookup.inside(of), component.type.names)
            where = _transformation(component, layer)
            extent, origin, rotation = (
                _argument(where, key) for key in ("extent", "origin", "rotation")
            )
            if kind is not None and extent is not None:
                start = np.array(value(origin) if origin else (0, 0), dtype=float)
                angle = float(value(rotation)) if rotation else 0.0
                parts.append(
                    Placed(component.name, kind, np.array(value(extent), dtype=float), start, angle)
                )
            elif kind is not None and _must_be_placed(kind, component) and unplaced is not None:
                unplaced.append(component.name)
        return parts

    def lines(self, of: Class) -> list[tuple[Connect, Shape | None]]:
        """The connections of a class itself, each with its line."""
        connections = [
            c for section in of.definition.sections for c in _connections(section.equations)
        ]
        return [(c, _line(of.definition.source, c.annotation)) for c in connections]

    def drawn_lines(self, of: Class) -> list[Shape]:
        """The lines of a class's connections, inherited ones first."""
        inherited = [line for base in self.lookup.bases(of) for line in self.drawn_lines(base)]
        return inherited + [line for _, line in self.lines(of) if line is not None]


def _connections(equations: Sequence[Equation]) -> Iterator[Connect]:
    """Those in loops too."""
    for equation in equations:
        if isinstance(equation, Connect):
            yield equation
        elif isinstance(equation, For):
            yield from _connections(equation.body)


def _must_be_placed(kind: Class, component: ComponentDeclaration) -> bool:
    return kind.definition.kind in DRAWN and "outer" not in component.prefixes


def _transformation(component: ComponentDeclaration, layer: str) -> Modification:
    """Where a component stands in a layer; the icon has a place of its own only where one is stated."""
    placement = component.annotation.argument("Placement")
    if placement is None:
        return EMPTY
    keys = ("iconTransformation", "transformation") if layer == "Icon" else ("transformation",)
    stated = (placement.modification.argument(key) for key in keys)
    return next((argument.modification for argument in stated if argument is not None), EMPTY)


def _argument(modification: Modification, *path: str) -> Expression | None:
    for name in path:
        argument = modification.argument(name)
        if argument is None:
            return None
        modification = argument.modification
    return modification.value


def _line(source: SourceText, span: tuple[int, int]) -> Shape | None:
    if span == (0, 0):
        return None
    text = SourceText(source.file, source.text[span[0] : span[1]])
    shape: Shape = value(ExpressionParser(text, tokenise(text)).expression())
    return shape


def value(expression: Expression) -> Any:
    """A literal of an annotation: numbers, lists, ``(name, arguments)`` of records, names as text."""
    match expression:
        case Literal():
            return expression.value
        case Unary(operand=Literal(value=number)):
            return -float(number)
        case Array():
            return [value(item) for item in expression.items]
        case Call():
            return expression.function.text, {name: value(item) for name, item in expression.named}
        case Reference():
            return expression.text
        case _:
            raise ValueError(f"no literal of an annotation: {expression}")


# ---- drawing ----------------------------------------------------------------------------------------------


def draw(axes: Axes, shapes: Sequence[Shape], at: Map, name: str, scale: float) -> None:
    """Draws shapes; ``scale`` is points of the screen by millimetre of a line at thickness 1."""
    for kind, given in shapes:
        thickness: float = given.get("thickness", given.get("lineThickness", 0.25))  # type: ignore[assignment]
        width = thickness * 2 * scale
        style = "--" if "Dash" in given.get("pattern", "") else "-"
        if kind == "Text":
            low, high = at(np.array(given["extent"], dtype=float))
            size = abs(high[1] - low[1]) * scale * (0.9 if "%name" in given["textString"] else 1.3)
            text = given["textString"].replace("%name", name)
            middle = (low + high) / 2
            axes.text(
                float(middle[0]),
                float(middle[1]),
                text,
                ha="center",
                va="center",
                size=size,
                color=_colour(given["textColor"]),
            )
        elif kind == "Line":
            points = at(_smooth(given))
            colour = _colour(given.get("color", [0, 0, 0]))
            axes.plot(*points.T, color=colour, lw=width, ls=style, solid_capstyle="butt")
            for end, ends in zip(
                given.get("arrow", ()), (points[:2], points[:-3:-1]), strict=False
            ):
                if end != "Arrow.None":
                    _arrow(axes, ends, colour, width, scale)
        else:
            fill = (
                _colour(given["fillColor"]) if "Solid" in given.get("fillPattern", "") else "none"
            )
            edge = _colour(given.get("lineColor", [0, 0, 0]))
            axes.add_patch(
                patches.Polygon(
                    at(_outline(kind, given)), fc=fill, ec=edge, lw=width, ls=style, zorder=2
                )
            )


def _colour(rgb: Sequence[float]) -> tuple[float, ...]:
    return tuple(part / 255 for part in rgb)


def _smooth(given: dict[str, Any]) -> Points:
    """Points of a line; with Smooth.Bezier, parabolas between the middles of its segments."""
    points = np.array(given["points"], dtype=float)
    if "Bezier" not in given.get("smooth", "") or len(points) < 3:
        return points
    middles = (points[1:] + points[:-1]) / 2
    t = np.linspace(0, 1, 12)[:, None]
    arcs = [
        (1 - t) ** 2 * a + 2 * t * (1 - t) * b + t**2 * c
        for a, b, c in zip(middles[:-1], points[1:-1], middles[1:], strict=True)
    ]
    return np.vstack([points[:1], *arcs, points[-1:]])


def _outline(kind: str, given: dict[str, Any]) -> Points:
    """Corners of a polygon, an ellipse or a rectangle with or without round corners."""
    if kind == "Polygon":
        return np.array(given["points"], dtype=float)
    (x0, y0), (x1, y1) = np.sort(np.array(given["extent"], dtype=float), axis=0)
    half = np.array([x1 - x0, y1 - y0]) / 2
    angle = np.linspace(0, 2 * np.pi, 61)[:-1] + np.pi / 60
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    radius = half if kind == "Ellipse" else np.full(2, min(given.get("radius", 0), *half))
    points: Points = (
        np.array([x0 + x1, y0 + y1]) / 2 + np.sign(circle) * (half - radius) + circle * radius
    )
    return points


def _arrow(axes: Axes, ends: Points, colour: tuple[float, ...], width: float, scale: float) -> None:
    head = {
        "arrowstyle": "-|>",
        "color": colour,
        "lw": width,
        "shrinkA": 0,
        "shrinkB": 0,
        "mutation_scale": 12 * scale,
    }
    axes.annotate("", ends[0], ends[1], arrowprops=head)


def _inside(part: Placed, at: Map) -> Map:
    return lambda points: at(part.at(points))


def draw_icon(axes: Axes, pictures: Pictures, of: Class, at: Map, name: str, scale: float) -> None:
    """The icon of a class and those of its connectors on it."""
    draw(axes, pictures.shapes(of), at, name, scale)
    for part in pictures.parts(of, layer="Icon"):
        if part.of.definition.kind == "connector":
            draw(axes, pictures.shapes(part.of), _inside(part, at), part.name, scale)


def diagram(pictures: Pictures, name: str, wide: float = 8.0) -> Figure:
    """The diagram of a class; ``wide`` in inches."""
    of = pictures.of(name)
    low, high = pictures.extent(of)
    figure = Figure((wide, wide * (high[1] - low[1]) / (high[0] - low[0])))
    axes = _frame(figure.add_axes((0, 0, 1, 1)), low, high)
    scale = wide * 72 / (high[0] - low[0])
    draw(axes, pictures.shapes(of, "Diagram"), lambda p: p, of.definition.name, scale / 2)
    draw(axes, pictures.drawn_lines(of), lambda p: p, "", scale)
    for part in pictures.parts(of):
        draw_icon(axes, pictures, part.of, part.at, part.name, scale / 2)
    return figure


def gallery(
    pictures: Pictures, names: Sequence[str], columns: int = 8, wide: float = 8.0
) -> Figure:
    """The icons of classes side by side."""
    rows = -(-len(names) // columns)
    figure = Figure((wide, rows * wide / columns))
    for i, name in enumerate(names):
        box = (i % columns / columns, 1 - (i // columns + 1) / rows, 1 / columns, 1 / rows)
        axes = _frame(figure.add_axes(box), (-150, -130), (150, 170))
        of = pictures.of(name)
        draw_icon(
            axes, pictures, of, lambda p: p, of.definition.name, wide / columns * 72 / 300 / 1.5
        )
    return figure


def _frame(axes: Axes, low: Sequence[float], high: Sequence[float]) -> Axes:
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    axes.axis("off")
    return axes
