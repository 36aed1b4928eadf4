"""No module of the workbench imports itself by way of others, also within functions and for type checkers."""

from __future__ import annotations

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pam_cosim.workbench

ROOM = Path(pam_cosim.workbench.__file__).parent


def name_of(file: Path) -> str:
    parts = ("pam_cosim.workbench", *file.relative_to(ROOM).with_suffix("").parts)
    return ".".join(part for part in parts if part != "__init__")


def test_imports_go_in_no_circle() -> None:
    files = {name_of(file): file for file in ROOM.rglob("*.py")}
    imports = {
        name: {
            node.module
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
            if isinstance(node, ast.ImportFrom) and node.module in files
        }
        for name, file in files.items()
    }
    order = list(TopologicalSorter(imports).static_order())  # raises CycleError
    session = order.index("pam_cosim.workbench.session")
    assert order.index("pam_cosim.workbench.commands") < session
