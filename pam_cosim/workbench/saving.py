"""A study of the workbench as files of its folder: what was done, and what came of it; written whole or not at all."""

from __future__ import annotations

import hashlib
import re
import time
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pam_cosim.diagnosis import Candidate, Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import plain as as_plain
from pam_cosim.files import read_json, write_bytes, write_json
from pam_cosim.fitting import Fit, HoldoutUncertainty
from pam_cosim.study.products import load, save
from pam_cosim.workbench.paths import inside
from pam_cosim.workbench.protocol import LadderStep, Level
from pam_cosim.workbench.saved import SavedContent, SavedRung, checked_content, plain_step
from pam_cosim.workbench.state import Ends, State
from pam_cosim.workbench.steps import step_of

FILE = "workbench.json"
_FORMAT = "pam-cosim workbench 1"
_PRODUCT = re.compile(
    r"workbench-(fit|diagnosis)-[0-9a-f]{12}\.npz"
)  # what a study may remove with itself


@dataclass(frozen=True)
class SavedStudy:
    """Where a study was written, and when (seconds since the epoch)."""

    file: str
    time: float


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


def save_state(state: State, folder: Path) -> SavedStudy:
    """Writes a study into its folder: ``workbench.json``, and beside it the last fit and the last diagnosis.

    Raises:
        InputError: the folder cannot be written.
    """
    target = inside(folder, FILE)
    before = _products(target)
    content: dict[str, Any] = {
        "format": _FORMAT,
        "model": state.model,
        "effects": list(state.effects),
        "values": dict(state.values),
        "diagnosed": list(state.diagnosed),
        "milestone": state.milestone,
        "file": state.file,
        "roles": {run.name: run.role for run in state.data.runs},
        "cuts": {name: list(ends) for name, ends in state.cuts.items()},
        "starts": dict(state.starts),
        "ladder": as_plain(state.rungs),
        "steps": [step.as_dict() for step in state.steps],
        "fit": _kept(state.fit, folder, "fit"),
        "diagnosis": _kept(state.diagnosis, folder, "diagnosis"),
        "time": time.time(),
    }
    write_json(target, content)
    for name in before - {content["fit"], content["diagnosis"]}:
        with suppress(OSError, InputError):
            inside(folder, name).unlink()
    return SavedStudy(target.name, content["time"])


def _products(file: Path) -> set[str]:
    """Names of the files that a saved study refers to."""
    try:
        content = read_json(file)
    except InputError:
        return set()
    named = [content.get("fit"), content.get("diagnosis")] if isinstance(content, dict) else []
    return {name for name in named if isinstance(name, str) and _PRODUCT.fullmatch(name)}


def _kept(product: Fit | Diagnosis | None, folder: Path, what: str) -> str | None:
    """Writes a product under a name that says what is in it: a study refers to what was there when it was saved."""
    if product is None:
        return None
    with TemporaryDirectory(prefix="pam-cosim-") as scratch:
        content = save(product, Path(scratch) / "product.npz").read_bytes()
    name = f"workbench-{what}-{hashlib.sha256(content).hexdigest()[:12]}.npz"
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
        raise InputError("is no study that the workbench saved", target)
    try:
        return _state(
            checked_content(content, {first.model, first.data.model, first.data.bench}),
            folder,
            first,
        )
    except ValueError as problem:
        raise InputError(f"the saved study was damaged: {problem}", target) from problem


def _state(content: SavedContent, folder: Path, first: State) -> State:
    roles = content.roles
    if set(roles) != {run.name for run in first.data.runs}:
        raise InputError(
            "the saved study is of other runs than the data set has now", folder / FILE
        )
    same = all(roles[run.name] == run.role for run in first.data.runs)
    runs = tuple(replace(run, role=roles[run.name]) for run in first.data.runs)
    cuts: dict[str, Ends] = {name: (begin, end) for name, (begin, end) in content.cuts.items()}
    return State(
        cuts=cuts,
        starts=dict(content.starts),
        data=first.data if same else replace(first.data, runs=runs),
        model=content.model,
        effects=tuple(content.effects),
        values=dict(content.values),
        fit=_product(content.fit, folder, Fit),
        diagnosis=_product(content.diagnosis, folder, Diagnosis),
        diagnosed=tuple(content.diagnosed),
        rungs=tuple(_rung(one) for one in content.ladder),
        milestone=content.milestone,
        steps=tuple(step_of(plain_step(one)) for one in content.steps),
        loaded=len(content.steps),
        file=content.file,
    )


def _rung(saved: SavedRung) -> LadderStep:
    fit, holdout = (
        {name: Level(**level.model_dump()) for name, level in by.items()}
        for by in (saved.fit, saved.holdout)
    )
    return LadderStep(saved.label, fit, holdout, saved.chi2_fit, saved.chi2_holdout)


def _product(name: str | None, folder: Path, kind: type[Any]) -> Any:
    if name is None:
        return None
    product = load(inside(folder, name))
    if not isinstance(product, kind):
        raise ValueError(f"{name} holds something else")
    return product
