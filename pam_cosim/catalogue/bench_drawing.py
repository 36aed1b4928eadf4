"""The Modelica text of a composed bench, with every part placed and every line drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape

from pam_cosim.catalogue.bench_parts import BenchPart
from pam_cosim.catalogue.rig_signals import declarations
from pam_cosim.compiler import ClassTree
from pam_cosim.compiler.class_info import ComponentInfo
from pam_cosim.compiler.printing import string_text

_HALF = 20  # of the width of a part in the diagram
_CLEAR = 15  # below what stands side by side, for a line across


@dataclass(frozen=True)
class PlacedPart:
    """A part under the name that it has in the rig; ``number`` is that of its muscle, zero for what all share."""

    part: BenchPart
    name: str
    number: int
    corner: tuple[int, int]


_End = tuple[PlacedPart, ComponentInfo]
_Point = tuple[float, float]
_Corner = tuple[int, int]


class BenchDrawing:
    """Components, connections and signals of a bench, one after another, and the text of all.

    Args:
        tree: the library.
    """

    def __init__(self, tree: ClassTree) -> None:
        self.tree = tree
        self.outputs: dict[str, ComponentInfo] = {}
        self.components: list[str] = []
        self.equations: list[str] = []

    def add(self, placed: PlacedPart, modifiers: Sequence[str]) -> None:
        """A component with these modifiers, such as ``V=0.002``."""
        modifier = f"({', '.join(modifiers)})" if modifiers else ""
        x, y = placed.corner
        extent = _extent((x, y), (x + 2 * _HALF, y + 2 * _HALF))
        place = f"annotation (Placement(transformation(extent={extent})))"
        description = string_text(placed.part.description)
        self.components.append(
            f"{placed.part.qualified_name} {placed.name}{modifier} {description}\n    {place}"
        )

    def connect(self, begin: _End, end: _End) -> None:
        """A line between two connectors."""
        joined = ", ".join(f"{placed.name}.{connector.name}" for placed, connector in (begin, end))
        points = ", ".join(f"{{{x:g},{y:g}}}" for x, y in _line(begin, end))
        self.equations.append(f"connect({joined})\n    annotation (Line(points={{{points}}}))")

    def read(self, signal: str, reader: PlacedPart, declared: ComponentInfo) -> None:
        """A signal of the bench, which is what an instrument reads."""
        self.outputs[signal] = declared
        self.equations.append(f"{signal} = {reader.name}.{declared.name}")

    def text(
        self,
        name: str,
        frame: str,
        bindings: Sequence[str],
        parts: tuple[BenchPart, BenchPart, BenchPart],
        inputs: Mapping[str, ComponentInfo],
        extent: tuple[_Corner, _Corner],
    ) -> str:
        """The class.

        Args:
            name: of the class.
            frame: that it extends, with ``bindings`` of its parameters.
            parts: what feeds the muscle, what holds it, and the muscle.
            inputs: of the bench.
            extent: of the diagram.
        """
        feed, hold, muscle = parts
        description = "; ".join(
            [hold.description, *map(_lower, (feed.description, muscle.description))]
        )
        modifier = f"({', '.join(bindings)})" if bindings else ""
        declared = [*declarations(self.tree, "input", inputs, *extent)]
        declared += declarations(self.tree, "output", self.outputs, *extent)
        lines = [f"model {name} {string_text(description)}", f"  extends {frame}{modifier};"]
        lines += [f"  {line};" for line in (*declared, *self.components)]
        lines += ["equation", *(f"  {line};" for line in self.equations)]
        diagram = f"Diagram(coordinateSystem(preserveAspectRatio=true, extent={_extent(*extent)}))"
        experiment = self.tree.classes[frame].annotations.get("experiment")
        info = string_text("\n".join(self._documentation(parts, inputs)))
        notes = ",\n    ".join(filter(None, (diagram, experiment, f"Documentation(info={info})")))
        return "\n".join([*lines, f"  annotation ({notes});", f"end {name};", ""])

    def _documentation(
        self, parts: Sequence[BenchPart], inputs: Mapping[str, ComponentInfo]
    ) -> Iterator[str]:
        yield "<html>"
        yield "".join(f"<p>{escape(part.description)}.</p>" for part in parts)
        yield "<ul>"
        for signal, declared in inputs.items():
            yield f"<li>input <code>{escape(signal)}</code>: {escape(declared.description)}</li>"
        for signal, declared in self.outputs.items():
            yield f"<li>output <code>{escape(signal)}</code>: {escape(declared.description)}</li>"
        yield "</ul>"
        used = ", ".join(f"<code>{escape(p.qualified_name)}</code>" for p in parts)
        yield f"<p>Equations and sources: {used}.</p>"
        yield "</html>"


def _extent(low: _Corner, high: _Corner) -> str:
    return f"{{{{{low[0]},{low[1]}}},{{{high[0]},{high[1]}}}}}"


def _line(begin: _End, end: _End) -> list[_Point]:
    """Corners of a line between two connectors, level and upright, that leaves each away from its part."""
    (a, a_up), (b, b_up) = _exit(begin), _exit(end)
    if a_up and b_up:
        across = min(a[1], b[1]) + _CLEAR
        points = [a, (a[0], across), (b[0], across), b]
    elif a_up:
        points = [a, (a[0], b[1]), b]
    elif b_up:
        points = [a, (b[0], a[1]), b]
    else:
        middle = (a[0] + b[0]) / 2
        points = [a, (middle, a[1]), (middle, b[1]), b]
    return [a, b] if a[0] == b[0] or a[1] == b[1] else points


def _exit(end: _End) -> tuple[_Point, bool]:
    """Where a connector stands in the diagram, and whether it is at the top or the bottom of its part."""
    placed, connector = end
    x, y = connector.position or (0.0, 0.0)
    edge, low = placed.corner
    return (edge + _HALF * (1 + x / 100), low + _HALF * (1 + y / 100)), abs(y) > abs(x)


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:]
