"""A fit that can be interrupted and gone on with: every simulation's outcome, kept in a file.

Every method does the same thing every time. So to go on, a fit begins anew and is answered from the file until it comes
to what nobody has simulated yet; it ends where it would have without the interruption, to the last bit.
"""

from __future__ import annotations

import hashlib
import json
import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.counts import MOST_SIMULATIONS
from pam_cosim.errors import InputError
from pam_cosim.files import read_json, write_text
from pam_cosim.fitting.free import Free
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.options import FitOptions
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator

_KIND = "pam-cosim fit in progress"
_VERSION = 1
_EVERY = 1.0  # [s] between writes of the file
_ANSWERS = ("squares", "triangle", "cost", "glance", "found_other_starts")
_DAMAGE = (KeyError, TypeError, ValueError, IndexError, AttributeError, OverflowError)


@dataclass(frozen=True)
class Identity:
    """What a fit is of: two fits with the same identity go the same way.

    Attributes:
        model: its name.
        description: digest of the FMU's description, whose identifier stands for the equations.
        data: digest of the fit runs and the noise.
        parameters: free ones with bounds, starts and priors, and fixed ones.
        options: how it goes.
    """

    model: str
    description: str
    data: str
    parameters: str
    options: str

    def differs(self, other: Mapping[str, str]) -> str | None:
        """In what ``other``, which a file keeps, is another fit; None: it is the same."""
        if other["model"] != self.model:
            return f"keeps a fit of another model, {other['model']}, not {self.model}"
        if other["description"] != self.description:
            return f"keeps a fit of {self.model} as it was before it was changed"
        if other["data"] != self.data:
            return "keeps a fit to other data"
        if other["parameters"] != self.parameters:
            return "keeps a fit with other parameters, bounds or priors"
        return (
            "keeps a fit by another method or with other options"
            if other["options"] != self.options
            else None
        )


def identity_of(
    simulator: AnySimulator,
    data: DataSet,
    free: Sequence[Free],
    fixed: Mapping[str, float],
    options: FitOptions,
) -> Identity:
    """The identity of a fit.

    Args:
        simulator: the model.
        data: the measurement with its noise.
        free: the parameters that are fitted.
        fixed: values of others [SI].
        options: how it goes.
    """
    with ZipFile(simulator.path) as archive:
        description = hashlib.sha256(archive.read("modelDescription.xml")).hexdigest()
    parameters = json.dumps([[asdict(f) for f in free], sorted(fixed.items())])
    return Identity(
        simulator.interface.model, description, _digest(data), parameters, _options_text(options)
    )


def _options_text(options: FitOptions) -> str:
    limits = ("simulations", "deadline")  # a fit that a limit ended goes on
    saved = {name: value for name, value in asdict(options).items() if name not in limits}
    saved["leeway"] = saved.pop("holdout_uncertainty")  # the name in version 1 of the file
    return json.dumps(saved, sort_keys=True)


def _digest(data: DataSet) -> str:
    digest = hashlib.sha256()
    for run in data.fit_runs:
        known = sorted(data.parameters_of(run).items())
        digest.update(json.dumps([run.name, run.interpolation, known, *_beginning(run)]).encode())
        for name, values in [("time", run.time), *run.inputs.items(), *run.measurements.items()]:
            digest.update(name.encode() + np.ascontiguousarray(values).tobytes())
    noise = {
        n: [s.sigma, s.step, *([s.sigma_at_zero, s.sigma_of_reading] if s.sigma_of_reading else [])]
        for n, s in data.fitted_signals.items()
    }
    return hashlib.sha256(digest.digest() + json.dumps(noise).encode()).hexdigest()


def _beginning(run: Run) -> list[object]:
    """How a run begins."""
    start = run.start
    leading = [[n, t.tolist(), v.tolist()] for n, (t, v) in sorted(start.leading.items())]
    return [
        start.mode or "rest", start.seconds, sorted(start.before.items()), start.lead, leading,
        start.periodic, start.periods,
    ]  # fmt: skip


class FitLog:
    """The file: what was asked of an objective, and the answers.

    Args:
        path: read where it is there; written while the fit goes on and when it ends.
        identity: of the fit.

    Raises:
        InputError: the file keeps another fit, or is no such file.
    """

    def __init__(self, path: Path, identity: Identity) -> None:
        self.path, self.identity = path, identity
        self.failures: list[str] = []
        self._answers: dict[tuple[str, bytes], tuple[int, Any]] = {}
        self._written = time.monotonic()
        if path.exists():
            self._read(read_json(path))

    def __len__(self) -> int:
        return len(self._answers)

    def _read(self, content: Any) -> None:
        try:
            if (content["kind"], content["version"]) != (_KIND, _VERSION):
                raise ValueError
            other = self.identity.differs(content["identity"])
            answers = [_answer(entry) for entry in content["answers"]]
            self.failures = [str(f) for f in content["failures"]]
        except _DAMAGE:
            raise InputError(
                "is no fit that could be resumed, or was damaged; name another file", self.path
            ) from None
        if other is not None:
            raise InputError(
                f"{other}; name another file, or remove this one to begin anew", self.path
            )
        self._answers = dict(answers)

    def answer(self, question: str, z: Array) -> tuple[int, Any] | None:
        """How many evaluations there had been after it, and the answer; None: nobody has asked yet."""
        return self._answers.get((question, z.tobytes()))

    def keep(self, question: str, z: Array, evaluations: int, answer: Any) -> None:
        """One more answer."""
        self._answers[question, z.tobytes()] = evaluations, answer
        if time.monotonic() - self._written > _EVERY:
            self.write()

    def write(self) -> None:
        """Brings the file up to date.

        Raises:
            InputError: it cannot be written.
        """
        answers = [
            [question, np.frombuffer(z).tolist(), evaluations, _plain(answer)]
            for (question, z), (evaluations, answer) in self._answers.items()
        ]
        content = {
            "kind": _KIND,
            "version": _VERSION,
            "identity": asdict(self.identity),
            "failures": self.failures,
        }
        write_text(self.path, json.dumps(content | {"answers": answers}, allow_nan=False) + "\n")
        self._written = time.monotonic()


def _plain(answer: Any) -> Any:
    if isinstance(answer, np.ndarray):
        return answer.tolist()
    return answer if math.isfinite(answer) else None


def _answer(entry: Any) -> tuple[tuple[str, bytes], tuple[int, Any]]:
    question, z, evaluations, answer = entry
    kind, point = str(question).partition(" ")[0], _numbers(z, 1)
    if (
        kind not in _ANSWERS
        or type(evaluations) is not int
        or not 0 <= evaluations <= MOST_SIMULATIONS
    ):
        raise ValueError
    if kind == "triangle":
        value = _numbers(answer, 2)
        if value.shape[1] != len(point) + 1:
            raise ValueError
        return (question, point.tobytes()), (evaluations, value)
    number = math.inf if answer is None else float(_numbers(answer, 0))
    return (question, point.tobytes()), (evaluations, number)


def _numbers(content: Any, dimensions: int) -> Array:
    """As an array; raises one of ``_DAMAGE`` where it is none, or a number in it is not finite."""
    numbers = np.array(content, dtype=float)
    if numbers.ndim != dimensions or not np.isfinite(numbers).all():
        raise ValueError
    return numbers


class LoggedObjective(Objective):
    """An objective that looks into a log first.

    Attributes:
        looks: how often other start values were found: the same points have other answers from then on.
    """

    log: FitLog
    looks: int = 0

    def found_other_starts(self, z: Array) -> bool:
        """As ``Objective.found_other_starts``."""
        found = bool(self._from_log("found_other_starts", z))
        self.looks += found
        return found

    def squares(self, z: Array) -> float:
        """As ``Objective.squares``."""
        return float(self._from_log("squares", z))

    def triangle(self, z: Array) -> Array:
        """As ``Objective.triangle``."""
        return np.asarray(self._from_log("triangle", z))

    def cost(self, z: Array) -> float:
        """As ``Objective.cost``."""
        return float(self._from_log("cost", z))

    def glance(self, z: Array) -> float:
        """As ``Objective.glance``."""
        return float(self._from_log("glance", z))

    def _from_log(self, question: str, z: Array) -> Any:
        asked = f"{question} {self.looks}" if self.looks else question
        known = self.log.answer(asked, z)
        if known is not None:
            after, answer = known
            self.evaluations = max(
                self.evaluations, after
            )  # a point that is asked for again counts once
            if question in ("squares", "cost"):
                self.tracker.report(self.evaluations, answer / max(self.samples, 1.0), None)
            return answer
        answer = getattr(super(), question)(z)
        self.log.failures = self.failures
        self.log.keep(asked, z, self.evaluations, answer)
        return answer
