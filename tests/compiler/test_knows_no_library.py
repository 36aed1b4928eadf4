"""The language stands apart from what is written in it."""

from __future__ import annotations

import ast
from pathlib import Path

from pam_cosim.resources import modelica_root

PACKAGE = Path(__file__).parents[2] / "pam_cosim"
LIBRARY = [folder for folder in modelica_root().iterdir() if (folder / "package.mo").is_file()]


def modules(room: str) -> list[Path]:
    files = sorted((PACKAGE / room).rglob("*.py"))
    assert files
    return files


def imported(file: Path) -> set[str]:
    """Modules of the project that a module imports, also within functions and for type checkers."""
    nodes = list(ast.walk(ast.parse(file.read_text(encoding="utf-8"))))
    wholes = [n for n in nodes if isinstance(n, ast.ImportFrom) and n.module]
    names = {n.module or "" for n in wholes} | {
        f"{n.module}.{a.name}" for n in wholes for a in n.names
    }
    names |= {a.name for n in nodes if isinstance(n, ast.Import) for a in n.names}
    return {name for name in names if name.startswith("pam_cosim.")}


def test_no_library_has_a_name_in_the_compiler() -> None:
    """Nor does an effect: the names of the library's folders and of its classes are not in the source."""
    assert LIBRARY
    words = {package.name for package in LIBRARY}
    words |= {file.stem for package in LIBRARY for file in (package / "Effects").rglob("*.mo")} - {
        "package"
    }
    assert len(words) > 50
    told = [
        (file.name, word)
        for file in modules("compiler")
        for word in words
        if word in file.read_text()
    ]
    assert not told


def test_no_library_has_a_name_in_python() -> None:
    told = [
        file.relative_to(PACKAGE).as_posix()
        for file in modules(".")
        for package in LIBRARY
        if package.name in file.read_text(encoding="utf-8")
    ]
    assert not told


def test_no_circle_of_imports_in_the_compiler() -> None:
    """Counting imports within functions and for type checkers: each module stands on those before it."""
    prefix = "pam_cosim.compiler."
    names = {f.stem for f in modules("compiler")}
    needs = {
        f.stem: {n.removeprefix(prefix) for n in imported(f) if n.startswith(prefix)} & names
        for f in modules("compiler")
        if f.stem != "__init__"
    }
    order = []
    while ready := [n for n, before in needs.items() if not before]:
        order += ready
        needs = {n: before - set(ready) for n, before in needs.items() if n not in ready}
    assert needs == {}, "these import each other"
    assert len(order) > 30
