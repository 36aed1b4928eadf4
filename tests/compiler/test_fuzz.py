"""Damaged source text gives a ModelError, whatever the damage."""

import random

import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.compiler.lexer import tokenise
from pam_cosim.compiler.source import SourceText
from pam_cosim.errors import ModelError
from tests.compiler.run import MODELS

CASES = [
    ("Tanks", "SwitchedOn"),
    ("Muscles", "Redeclared"),
    ("Language", "Arrays"),
    ("Language", "Functions"),
    ("Language", "Records"),
    ("Language", "Rigid"),
    ("Delays", "Uses"),
]


def damaged(text: str, chance: random.Random) -> str:
    words = tokenise(SourceText("text", text)).texts[:-1]
    place, other = chance.randrange(4, len(words) - 3), chance.choice(words)
    how = chance.randrange(3)
    words[place : place + (how != 1)] = [] if how == 0 else [other]
    return " ".join(words)


@pytest.mark.parametrize(("package", "model"), CASES)
def test_damaged_source(package, model, tmp_path):
    chance = random.Random(f"{package}.{model}")
    text = (MODELS / f"{package}.mo").read_text()
    file = tmp_path / "damaged.mo"
    empty = tmp_path / "empty"
    empty.mkdir()
    refused = accepted = 0
    for _ in range(60):
        file.write_text(damaged(text, chance))
        try:
            compile_model(f"{package}.{model}", files=[file], root=empty)
            accepted += 1
        except ModelError as error:
            refused += 1
            assert error.message and (
                error.file is not None or "there is no model" in error.message
            )
    assert refused > 20 and accepted > 0
