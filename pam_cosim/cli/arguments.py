"""Words of the command line that stand for settings and inputs.

Every command loads it, so that it loads no room that only some of them need.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.model.interface import Variable
from pam_cosim.model.references import is_file
from pam_cosim.model.settings import value_of
from pam_cosim.wording import shown

_FILE_ENDING = re.compile(r"\.[A-Za-z]\w*")  # as of files; folders are named with versions


def fmu_files(models: Sequence[str], output: Path) -> list[tuple[str, Path]]:
    """Each model and the file for its FMU: ``output`` itself if its name ends in ``.fmu``, one in that folder if not.

    Raises:
        InputError: several models for one file; the name of another kind of file.
    """
    if output.suffix.lower() == ".fmu":
        if len(models) != 1:
            raise InputError(
                f"this is one file, for {len(models)} models; name one model, or a folder", output
            )
        return [(models[0], output)]
    if _FILE_ENDING.fullmatch(output.suffix) and not output.is_dir():
        raise InputError("FMUs are built: name a folder, or a file that ends in .fmu", output)
    from pam_cosim.compiler import names
    from pam_cosim.fmu.description import model_identifier

    files: dict[Path, str] = {}
    for model in models:
        name = Path(model).stem if is_file(model) else model_identifier(names.last(model))
        if files.setdefault(output / f"{name}.fmu", model) != model:
            raise InputError(
                f"two models would be written to '{name}.fmu'; build them into two folders", output
            )
    return [(model, file) for file, model in files.items()]


def parse_named(words: Sequence[str]) -> dict[str, str]:
    """``NAME=TEXT`` words by name; a word without a name is its own.

    Raises:
        InputError: an empty name or text, or a name twice.
    """
    named: dict[str, str] = {}
    for word in words:
        name, equals, text = (part.strip() for part in word.partition("="))
        if not name or (equals and not text):
            raise InputError(f"'{word}': write a scalar, such as max(p), or NAME=SCALAR")
        if name in named:
            raise InputError(f"'{name}' is given twice")
        named[name] = text if equals else name
    return named


def parse_varied(words: Sequence[str]) -> dict[str, str | list[str]]:
    """``NAME=FROM:TO:N``, ``NAME=FROM:TO`` and ``NAME=A,B,C`` words: spans and lists of texts by name.

    ``inputs=A.csv,B.csv`` is a list of files or of formulas.

    Raises:
        InputError: not of that form, or a name twice.
    """
    from pam_cosim.sweeps.patterns import INPUTS
    from pam_cosim.sweeps.spans import alike

    varied: dict[str, str | list[str]] = {}
    for word in words:
        name, text = _split(word, "NAME=FROM:TO:N or NAME=A,B,C")
        if name in varied:
            raise InputError(f"'{name}' is varied twice")
        if name == INPUTS:
            varied[name] = [value.strip() for value in text.split(",")]
        else:
            varied[name] = text if ":" in text else alike(text.split(","), word)
    return varied


def parse_point(words: Sequence[str]) -> Literal["rest"] | dict[str, str] | list[float]:
    """The value of ``--at``: "rest", values by name of one state, or times [s] of a run.

    Raises:
        InputError: not of that form, or several of these.
    """
    if list(words) == ["rest"]:
        return "rest"
    pairs = [
        _split(part, 'NAME=VALUE, such as "p=6 bar", or rest')
        for word in words
        for part in _parts(word)
    ]
    if not pairs:
        raise InputError(f'{shown(" ".join(words))}: write NAME=VALUE, such as "p=6 bar", or rest')
    names = [name for name, _ in pairs]
    if set(names) == {"time"}:
        return [value_of(text, Variable("time", "s")) for _, text in pairs]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"'{twice}' is given twice")
    if "time" in names:
        raise InputError(
            "a time is of a run and has its state; give either times or values of a state"
        )
    return dict(pairs)


def parse_pairs(words: Sequence[str] | None, lists: Sequence[str] = ()) -> dict[str, str]:
    """``NAME=VALUE`` words to texts by name; those of ``lists`` may be given again, which adds to them.

    Raises:
        InputError: not of that form, or a name twice.
    """
    pairs: dict[str, str] = {}
    for word in words or ():
        name, text = _split(word, "NAME=VALUE, such as p='0.5 kPa'")
        if name in pairs and name not in lists:
            raise InputError(f"'{name}' is given twice")
        pairs[name] = f"{pairs[name]},{text}" if name in pairs else text
    return pairs


def parse_limits(words: Sequence[str]) -> dict[str, tuple[str, str]]:
    """``NAME=FROM:TO`` words to lowest and highest values as texts, by name.

    Raises:
        InputError: not of that form, or a name twice.
    """
    from pam_cosim.sweeps.spans import alike

    limits: dict[str, tuple[str, str]] = {}
    for word in words:
        name, text = _split(word, "NAME=FROM:TO, such as u_in='0 A:0.35 A'")
        if name in limits:
            raise InputError(f"'{name}' is limited twice")
        ends = text.split(":")
        if len(ends) != 2:
            raise InputError(f"'{word}': write NAME=FROM:TO, such as u_in='0 A:0.35 A'")
        low, high = alike([end.strip() for end in ends], word)
        limits[name] = (low, high)
    return limits


def parse_cuts(words: Sequence[str]) -> dict[str, tuple[str | None, str | None]]:
    """``RUN=FROM:TO`` words to first and last times by run; one that is left out is None.

    Raises:
        InputError: not of that form, or a run twice.
    """
    cuts: dict[str, tuple[str | None, str | None]] = {}
    for word in words:
        run, text = _split(word, "RUN=FROM:TO, such as run-03=2.5:10")
        begin, colon, end = (part.strip() for part in text.partition(":"))
        if not colon or ":" in end:
            raise InputError(
                f"'{word}': write RUN=FROM:TO; one of the times may be left out, such as run-03=2.5:"
            )
        if run in cuts:
            raise InputError(f"'{run}' is cut twice")
        cuts[run] = (begin or None, end or None)
    return cuts


def parse_frequencies(text: str) -> list[float]:
    """``FROM:TO:N``, evenly in the logarithm, or ``A,B,C`` [Hz].

    Raises:
        InputError: not of that form.
    """
    from pam_cosim.sweeps.spans import MOST_RUNS, alike

    frequency, parts = Variable("frequencies", "Hz"), text.split(":")
    if len(parts) == 1:
        return [value_of(part, frequency) for part in text.split(",")]
    if len(parts) != 3 or not parts[2].strip().isdecimal():
        raise InputError(f"{shown(text)}: write FROM:TO:N, such as 0.1:20:16")
    number = parts[2].strip().lstrip("0") or "0"
    if len(number) > len(str(MOST_RUNS)) or not 1 <= int(number) <= MOST_RUNS:
        raise InputError(f"{shown(text)}: the number of frequencies is from 1 to {MOST_RUNS}")
    low, high = (value_of(part, frequency) for part in alike(parts[:2], text))
    if not 0 < low <= high:
        raise InputError(f"'{text}': frequencies must be above zero, the lower one first")
    return [float(v) for v in np.geomspace(low, high, int(number))]


def _parts(word: str) -> list[str]:
    """The parts between commas, but for those in brackets."""
    return [part for part in re.split(r",(?![^\[]*\])", word) if part.strip()]


def _split(word: str, form: str) -> tuple[str, str]:
    name, equals, text = word.partition("=")
    if not equals or not name.strip() or not text.strip():
        raise InputError(f"'{word}': write {form}")
    return name.strip(), text.strip()
