"""Prints messages and docstrings of the package, drawn at random: python -m scripts.sample_sentences [SEED] [COUNT]."""

from __future__ import annotations

import ast
import random
import sys
from collections.abc import Iterator
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1] / "pam_cosim"


def texts_of(node: ast.AST) -> Iterator[str]:
    """Texts of string literals below a node; ``{}`` for the values of f-strings."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.JoinedStr):
        yield "".join(str(v.value) if isinstance(v, ast.Constant) else "{}" for v in node.values)
    else:
        for child in ast.iter_child_nodes(node):
            yield from texts_of(child)


def sentences() -> tuple[list[str], list[str]]:
    """Messages of exceptions, and first lines of public docstrings, each with its file and line."""
    messages, docstrings = [], []
    for file in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            place = f"{file.relative_to(PACKAGE.parent)}:{getattr(node, 'lineno', 1)}: "
            if isinstance(node, ast.Raise) and node.exc is not None:
                text = " ".join(texts_of(node.exc))
                messages += [place + text] if len(text.split()) > 4 else []
            elif isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
                text = ast.get_docstring(node) or ""
                docstrings += [place + text.splitlines()[0]] if text else []
    return messages, docstrings


def main(seed: int = 75, count: int = 10) -> None:
    """Prints ``count`` of each."""
    for title, texts in zip(("messages", "docstrings"), sentences(), strict=True):
        print(f"{title}, {count} of {len(texts)}:")
        print(*random.Random(seed).sample(texts, count), sep="\n")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
