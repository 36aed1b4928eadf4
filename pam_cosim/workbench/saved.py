"""A study as files of its folder: what is in them, checked by pydantic before any of it is used, written and read.

The files may come from an untrusted source. Names become arguments of scripts, so that each is of a known kind: unknown
keys, steps and methods are errors that name their place.
"""

from __future__ import annotations

import hashlib
import re
import time
import unicodedata
from collections.abc import Collection, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Field,
    FiniteFloat,
    ValidationError,
    model_validator,
)

from pam_cosim.diagnosis import Candidate, Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import read_json, write_bytes, write_json
from pam_cosim.fitting import METHODS, Fit, HoldoutUncertainty
from pam_cosim.measurement import StartMode
from pam_cosim.measurement.experiment_tables import CheckedTable
from pam_cosim.model.references import is_file, is_ratio
from pam_cosim.study.products import load, save
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.paths import inside, is_name_here
from pam_cosim.workbench.protocol import selected
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import Step

FILE = "workbench.json"
LONGEST_NAME = 5000  # letters; quoted names of Modelica may be long
MOST = 10_000  # steps, names or values in one list
_FORMAT = "pam-cosim workbench 1"
_SAME = "model effects values diagnosed milestone file"  # in a file and in a state
_CLASS = re.compile(r"\.?(?:[^\W\d]\w*|'(?:[^'\\]|\\.)+')(?:\.(?:[^\W\d]\w*|'(?:[^'\\]|\\.)+'))*")
_PRODUCT = re.compile(
    r"workbench-(fit|diagnosis)-[0-9a-f]{12}\.npz"
)  # what a study may remove with itself


def _legible(text: str, *, spaces: str = "Zs") -> str:
    for c in text:
        if not (c.isprintable() or unicodedata.category(c) == spaces):
            raise ValueError(f"holds the character {ascii(c)}, which cannot be seen")
    return text


def _class_name(text: str) -> str:
    if not _CLASS.fullmatch(text):
        raise ValueError(f"{shown(text)} is no name of a Modelica class")
    return text


def _bench(text: str) -> str:
    if is_file(text):
        raise ValueError(f"{shown(text)} is a file; a saved study names classes only")
    return _class_name(text)


def _method(text: str) -> str:
    if text not in METHODS:
        raise ValueError(
            f"there is no method {shown(text)} to fit with; {did_you_mean(text, METHODS)}"
        )
    return text


def _file(text: str, *, ending: str, kind: str) -> str:
    if not text.endswith(ending) or not is_name_here(text):
        raise ValueError(f"{shown(text)} is no name of a {kind} the study's folder")
    return text


def _number(value: object) -> object:
    """A number that JSON has as an integer of any length."""
    if isinstance(value, bool) or not isinstance(value, int):
        return value
    try:
        return float(value)
    except OverflowError:
        raise ValueError("the number is too large") from None


_Many = Field(max_length=MOST)
Number = Annotated[FiniteFloat, BeforeValidator(_number)]
Text = Annotated[str, Field(max_length=LONGEST_NAME), AfterValidator(_legible)]
Name = Annotated[
    str, Field(min_length=1, max_length=LONGEST_NAME), AfterValidator(partial(_legible, spaces=""))
]
Names = Annotated[list[Name], _Many]
Effects = Annotated[
    list[
        Annotated[Name, AfterValidator(lambda text: text if is_ratio(text) else _class_name(text))]
    ],
    _Many,
]
Values = Annotated[dict[Name, Number], _Many]
Roles = Annotated[dict[Name, Literal["fit", "holdout"]], _Many]
Ends = Annotated[list[Number | None], Field(min_length=2, max_length=2)]
Cuts = Annotated[dict[Name, Ends], _Many]
Starts = Annotated[dict[Name, StartMode], _Many]
ModelicaFile = Annotated[
    Name, AfterValidator(partial(_file, ending=".mo", kind="Modelica file of"))
]
Product = Annotated[Name, AfterValidator(partial(_file, ending=".npz", kind="product in"))]


class SetStep(CheckedTable):
    """Values were set by hand [SI]; of start values those that ``moved``, and the others of their runs stayed."""

    do: Literal["set", "start"]
    values: Values
    moved: Names = []
    dragged: bool = False

    @model_validator(mode="after")
    def _has_its_values(self) -> SetStep:
        stray = next((name for name in self.moved if name not in self.values), None)
        if stray is not None:
            raise ValueError(f"values lacks {shown(stray)}")
        return self


class SwitchStep(CheckedTable):
    """The model was given just these effects; ``values`` were kept [SI]."""

    do: Literal["switch"]
    effects: Effects
    values: Values


class ChooseStep(CheckedTable):
    """Another base model was taken."""

    do: Literal["choose"]
    model: Annotated[Name, AfterValidator(_bench)]


class FitStep(CheckedTable):
    """Parameters were fitted, from these values [SI]; ``kept``: the others that it began with, where values had been
    moved while it was stopped."""

    do: Literal["fit"]
    method: Annotated[Name, AfterValidator(_method)]
    free: Names
    start: Values
    kept: Values = {}


class DiagnoseStep(CheckedTable):
    """The missing effect was looked for."""

    do: Literal["diagnose"]
    time_limit: Number | Name | None = None
    exclude: Names = []
    expect: Names = []
    free: Names = []
    start: Values = {}


class TakeStep(CheckedTable):
    """A model of the ranking was taken: its values, and those that were kept [SI]."""

    do: Literal["take"]
    effects: Effects
    values: Values
    kept: Values


class AddStep(CheckedTable):
    """The model with effects was written, with these values [SI]."""

    do: Literal["add"]
    effects: Effects
    values: Values = {}
    file: ModelicaFile


class Chosen(CheckedTable):
    """What is chosen in place of what the data set states; see ``MeasurementSource.read``."""

    roles: Roles = {}
    cuts: Cuts = {}
    starts: Starts = {}
    signals: Annotated[dict[Name, Number | None], _Many] = {}
    values: Values = {}
    free: Names = []


class ChosenStep(CheckedTable):
    """Something was chosen; all that is chosen since then, and the values that were kept [SI]."""

    do: Literal["roles", "cut", "begin", "signal", "free", "state"]
    text: Text
    chosen: Chosen
    values: Values


AnyStep = Annotated[
    SetStep | SwitchStep | ChooseStep | FitStep | DiagnoseStep | TakeStep | AddStep | ChosenStep,
    Field(discriminator="do"),
]  # fmt: skip


class SavedLevel(CheckedTable):
    """One signal on a rung of the ladder."""

    rms: Number | None
    text: Text


class SavedRung(CheckedTable):
    """A rung of the ladder."""

    label: Text
    fit: Annotated[dict[Name, SavedLevel], _Many]
    holdout: Annotated[dict[Name, SavedLevel], _Many]
    chi2_fit: Number | None
    chi2_holdout: Number | None


class SavedContent(CheckedTable):
    """The file of a study."""

    format: Literal["pam-cosim workbench 1"]
    model: Name
    effects: Effects
    values: Values
    diagnosed: Effects
    milestone: Text
    file: ModelicaFile | None
    runs: Names
    chosen: Chosen
    ladder: Annotated[list[SavedRung], _Many]
    steps: Annotated[list[AnyStep], _Many]
    fit: Product | None
    diagnosis: Product | None
    time: Number


def checked_content(content: Any, models: Collection[str]) -> SavedContent:
    """The content of a saved study; ``models``: files that the person who opens it named.

    Raises:
        ValueError: something in it cannot be; names the place.
    """
    try:
        saved = SavedContent.model_validate(content)
    except ValidationError as error:
        raise ValueError(complaint(error)) from None
    if saved.model not in models:
        try:
            _bench(saved.model)
        except ValueError as problem:
            raise ValueError(f"model: {problem}") from None
    return saved


def complaint(error: ValidationError) -> str:
    """What is wrong, and where."""
    worst = min(
        error.errors(include_url=False), key=lambda details: details["type"] != "extra_forbidden"
    )
    place = ".".join(part if isinstance(part, str) else str(part + 1) for part in worst["loc"])
    words = str(worst.get("ctx", {}).get("error", worst["msg"]))
    return f"{shown(place)[1:-1]}: {words}" if place else words


def lean(diagnosis: Diagnosis) -> Diagnosis:
    """A diagnosis without the curves of candidates that were not added: their scores and values stay."""
    way = {c.effects for c in diagnosis.path}

    def bare(c: Candidate) -> Candidate:
        return c if c.effects in way else replace(c, fit=lean_fit(c.fit))

    return replace(diagnosis, candidates=tuple(bare(c) for c in diagnosis.candidates))


def lean_fit(fit: Fit) -> Fit:
    """A fit without its curves: values, intervals and scores stay."""
    comparison = replace(fit.comparison, data=replace(fit.comparison.data, runs=()), runs=())
    return replace(
        fit, comparison=comparison, linear=None, holdout_uncertainty=HoldoutUncertainty()
    )


def save_state(state: State, folder: Path) -> str:
    """Writes a study into its folder: ``workbench.json``, and with it the last fit and the last diagnosis.

    Returns:
        The name of the file.

    Raises:
        InputError: the folder cannot be written.
    """
    target = inside(folder, FILE)
    before = _products(target)
    products = {kind: _kept(getattr(state, kind), folder, kind) for kind in ("fit", "diagnosis")}
    content = {
        "format": _FORMAT,
        "runs": [run.name for run in state.data.runs],
        "chosen": state.chosen,
        "ladder": state.rungs,
        "steps": state.steps,
        "time": time.time(),
    }
    write_json(target, content | products | selected(state, _SAME))
    for name in before - {*products.values()}:
        with suppress(OSError, InputError):
            inside(folder, name).unlink()
    return target.name


def _products(file: Path) -> set[str]:
    """Names of the files that a saved study refers to."""
    try:
        content = read_json(file)
    except InputError:
        return set()
    file_names = [content.get("fit"), content.get("diagnosis")] if isinstance(content, dict) else []
    return {name for name in file_names if isinstance(name, str) and _PRODUCT.fullmatch(name)}


def _kept(product: Fit | Diagnosis | None, folder: Path, kind: str) -> str | None:
    """Writes a product under a name that says what is in it: a study refers to what was there when it was saved."""
    if product is None:
        return None
    with TemporaryDirectory(prefix="pam-cosim-") as scratch:
        content = save(product, Path(scratch) / "product.npz").read_bytes()
    name = f"workbench-{kind}-{hashlib.sha256(content).hexdigest()[:12]}.npz"
    write_bytes(inside(folder, name), content)
    return name


def load_state(folder: Path, first: State) -> State:
    """The study that was saved in a folder, its data not yet cut; ``first``: as it was opened, with the data.

    Raises:
        InputError: there is none, it was damaged, or it is of other data.
    """
    target = inside(folder, FILE)
    content = read_json(target)
    if not isinstance(content, Mapping) or content.get("format") != _FORMAT:
        raise InputError("is not a saved study of the workbench", target)
    try:
        return _state(
            checked_content(content, {first.model, first.data.model, first.data.bench}),
            folder,
            first,
        )
    except ValueError as problem:
        raise InputError(f"the saved study was damaged: {problem}", target) from problem


def _state(content: SavedContent, folder: Path, first: State) -> State:
    if content.runs != [run.name for run in first.data.runs]:
        raise InputError(
            "the saved study is of other runs than the data set has now", folder / FILE
        )
    return State(
        data=first.data,
        known=first.known,
        chosen=content.chosen.model_dump(exclude_unset=True),
        fit=_product(content.fit, folder, Fit),
        diagnosis=_product(content.diagnosis, folder, Diagnosis),
        rungs=tuple(rung.model_dump() for rung in content.ladder),
        steps=tuple(_step(step) for step in content.steps),
        loaded=len(content.steps),
        **selected(content, _SAME)
        | {"effects": tuple(content.effects), "diagnosed": tuple(content.diagnosed)},
    )


def _step(saved: CheckedTable) -> Step:
    arguments = saved.model_dump(exclude_unset=True)
    return Step(arguments.pop("do"), arguments)


def _product(name: str | None, folder: Path, kind: type[Any]) -> Any:
    if name is None:
        return None
    product = load(inside(folder, name))
    if not isinstance(product, kind):
        raise ValueError(f"{name} holds something else")
    return product
