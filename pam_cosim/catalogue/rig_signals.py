"""The inputs and outputs of a composed bench as Modelica declarations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from pam_cosim.catalogue.place import is_signal
from pam_cosim.compiler import ClassTree
from pam_cosim.compiler.class_info import ComponentInfo
from pam_cosim.compiler.printing import string_text

_HALF = 10  # of the width of a connector
_Corner = tuple[float, float]


def declarations(
    tree: ClassTree, prefix: str, signals: Mapping[str, ComponentInfo], low: _Corner, high: _Corner
) -> Iterator[str]:
    """Signals of parts as those of the bench; connectors stand on the left edge (inputs) or on the right one (outputs).

    Args:
        tree: the library and the user's files.
        prefix: "input" or "output".
        signals: declarations of the parts by their names in the bench.
        low, high: corners of the bench's diagram.
    """
    placed = [name for name, declared in signals.items() if is_signal(tree, declared.type)]
    for name, declared in signals.items():
        if name not in placed:
            yield f"{prefix} {_declaration(declared, name)}"
            continue
        share = (placed.index(name) + 1) / (len(placed) + 1)
        level = round(high[1] + share * (low[1] - high[1]))
        diagram = (low[0] if prefix == "input" else high[0], level)
        icon = (-100 if prefix == "input" else 100, round(100 - 200 * share))
        places = f"transformation({_extent(diagram)}),\n      iconTransformation({_extent(icon)})"
        yield f"{_declaration(declared, name)}\n    annotation (Placement({places}))"


def _declaration(declared: ComponentInfo, name: str) -> str:
    """A variable of a part under another name, without its value."""
    attributes = declared.text
    if declared.value:
        attributes = (
            attributes.removesuffix(f"={declared.value}")
            .removesuffix(f"= {declared.value}")
            .strip()
        )
    sizes = f"[{', '.join(declared.dimensions)}]" if declared.dimensions else ""
    return f"{declared.type} {name}{sizes}{attributes} {string_text(declared.description)}"


def _extent(middle: _Corner) -> str:
    x, y = middle
    return f"extent={{{{{x - _HALF:g},{y - _HALF:g}}},{{{x + _HALF:g},{y + _HALF:g}}}}}"
