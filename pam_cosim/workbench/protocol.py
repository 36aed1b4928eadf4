"""What passes between a session and its windows, as data: events, and the binary frames of curves.

A page sends commands, JSON objects such as ``{"id": 7, "do": "set", "values": {"valve.C_A": 0.7}}``; the answer is an
event ``answer`` with that ``id`` to the window that asked, and whatever changes is told to all windows. Every event is
a JSON object whose key ``event`` names it: the class's name in lower case. Values are in the shown units (``unit``
beside them), times in seconds; a number that does not exist is null.

A frame of curves is one binary message: the length of a header (unsigned, 4 bytes, little-endian), the header (JSON,
padded with spaces so that what follows begins at a multiple of 4 bytes), then 32-bit floats. The header is
``{"event": "curves", "kind": kind, "version": n, "answers": id, "label": text, "runs": [{"name": run, "from": time,
"signals": [{"name": signal, "n": count, "values_at": place, ...}]}]}``, places in floats. In a frame of kind
"measured" each signal has ``time_at`` too, of all that was recorded, counted from the time that its run has as
``from``: 32 bits hold the time since 1970 to two minutes only. In one of kind "model", or "reference" (the model as it
was before the last step), it has ``residual_at``; "reference" without runs: there is no such model any more. The values
are those at the times of the measured ones; missing samples, and the model where a run was cut, are NaN.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, ClassVar

from pam_cosim.files import plain, plain_fields

Json = dict[str, Any]


@dataclass(frozen=True)
class PageEvent:
    """Something that is told to windows."""

    event: ClassVar[str]
    """Its name in messages."""
    kept: ClassVar[bool] = False
    """Whether a window that opens later is told the last one of its kind."""
    every: ClassVar[bool] = False
    """Whether it is told all of them, since the last long thing began."""

    def as_dict(self) -> Json:
        """Plain data for JSON."""
        return {"event": self.event, **plain_fields(self)}

    def message(self) -> str:
        """The message as it is sent."""
        return json.dumps(self.as_dict(), allow_nan=False)


@dataclass(frozen=True)
class ShownRun:
    """A run.

    Attributes:
        duration: [s]; of points at rest, their number.
        static: points at rest; their "times" in frames are values of what they are drawn over, ``along`` with its unit.
        describe: a line about it.
        parameters: what is known of it, as text.
        begins, ends: first and last time [s] that count; frames have all that was recorded.
    """

    name: str
    role: str
    duration: float
    static: bool
    along: str
    samples: int
    describe: str
    parameters: tuple[str, ...] = ()
    begins: float = 0.0
    ends: float = 0.0


@dataclass(frozen=True)
class ShownSignal:
    """A measured signal.

    Attributes:
        quantity: what it is, in the words of the model.
        noise: standard deviation of its instrument [unit].
        use: "fitted", or "compared".
    """

    name: str
    unit: str
    quantity: str
    noise: float | None
    noise_text: str
    use: str


@dataclass(frozen=True)
class ShownParameter:
    """A parameter with a slider.

    Attributes:
        name: in the model, with "@" and a run where it is of one run alone.
        unit: shown; ``value``, ``start``, ``low``, ``high`` and the interval are in it.
        start: where it began.
        effect: that brought it; None: the base model.
        logarithmic: a slider moves it by order of magnitude.
        low95, high95: 95 % interval of the last fit, as long as the value is that of the fit.
        text: value and interval as the report has them.
        remark: what to know of the value, such as that it is at its bound.
    """

    name: str
    unit: str
    value: float
    start: float
    low: float
    high: float
    description: str
    effect: str | None = None
    logarithmic: bool = False
    low95: float | None = None
    high95: float | None = None
    text: str = ""
    remark: str = ""


@dataclass(frozen=True)
class ShownEffect:
    """An effect of the catalogue.

    Attributes:
        equation: its equations, Modelica text.
        fingerprint: how it shows, in words. source: where it is from, likewise.
        on: it is in the model. fits: it finds a place in it.
    """

    name: str
    family: str
    balance: str
    description: str
    equation: str
    fingerprint: str
    source: str
    on: bool
    fits: bool


@dataclass(frozen=True)
class StudyEvent(PageEvent):
    """All that moves seldom.

    Attributes:
        state: "open", or "drop" where there is no data set yet.
        model: the base model. short: what it is called for short: a class by its last name, a file without its folder.
        with_effects: what is shown now, in words.
        notes: what a reader of results should know of the data.
        benches: models to choose from. methods: of a fit.
        file: what the model was written to, relative to the folder; None: it was not.
    """

    event: ClassVar[str] = "study"
    kept = True
    title: str
    folder: str
    state: str
    model: str = ""
    short: str = ""
    with_effects: str = ""
    runs: tuple[ShownRun, ...] = ()
    signals: tuple[ShownSignal, ...] = ()
    parameters: tuple[ShownParameter, ...] = ()
    effects: tuple[ShownEffect, ...] = ()
    families: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    benches: tuple[str, ...] = ()
    methods: tuple[str, ...] = ()
    file: str | None = None


@dataclass(frozen=True)
class StepsEvent(PageEvent):
    """What was done so far, a line ``{"text"}`` each; saved: it has been saved as it is."""

    event: ClassVar[str] = "steps"
    kept = True
    steps: tuple[Json, ...]
    saved: bool


@dataclass(frozen=True)
class Level:
    """Of one signal, in its unit: root mean square error and noise; the chi-square is the reduced one."""

    rms: float | None
    noise: float | None
    chi2: float | None
    text: str
    noise_text: str


@dataclass(frozen=True)
class LadderStep:
    """One step of the error ladder: by signal, on the runs of each role."""

    label: str
    fit: dict[str, Level]
    holdout: dict[str, Level]
    chi2_fit: float | None
    chi2_holdout: float | None


@dataclass(frozen=True)
class ScoresEvent(PageEvent):
    """How far the model is from the measurement.

    Attributes:
        scores: by role and signal.
        runs: root mean square errors by run and signal. sizes: of each run, in noise standard deviations.
        ladder: the steps that were done; the last rung is the standing model, which moves with the sliders.
        failed: runs that could not be simulated, ``{"run", "text"}``; then everything else is as it was.
        values: of the parameters.
        warnings: of the model, each with its runs.
    """

    event: ClassVar[str] = "scores"
    kept = True
    version: int
    scores: dict[str, dict[str, Level]]
    runs: dict[str, dict[str, float]]
    sizes: dict[str, float | None]
    ladder: tuple[LadderStep, ...]
    values: dict[str, float]
    failed: tuple[Json, ...] = ()
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class ErrorRegion:
    """Where error sits: shares of the squared error beyond the noise and of the samples; where that is, by run [s]."""

    id: int
    signal: str
    rule: str
    error_share: float
    time_share: float
    text: str
    ranges: dict[str, list[tuple[float, float]]]


@dataclass(frozen=True)
class ErrorRegionsEvent(PageEvent):
    """Rules that hold most of the error."""

    event: ClassVar[str] = "where"
    kept = True
    version: int
    rules: tuple[ErrorRegion, ...]


@dataclass(frozen=True)
class StartValue:
    """Where one state begins: its ``value`` [unit] between the ends of a slider, and the interval of an estimate."""

    name: str
    label: str
    unit: str
    value: float
    low: float
    high: float
    description: str
    low95: float | None = None
    high95: float | None = None


@dataclass(frozen=True)
class ShownStart:
    """How a run begins.

    Attributes:
        mode: one of ``modes``, or "periodic", or "by hand" where start values were set.
        text: a sentence.
        warning: the model cannot be where the first samples are.
        values: of the states, none where they cannot be set.
    """

    run: str
    mode: str
    text: str
    warning: bool
    modes: tuple[str, ...]
    values: tuple[StartValue, ...]


@dataclass(frozen=True)
class StartsEvent(PageEvent):
    """How each recording begins."""

    event: ClassVar[str] = "starts"
    kept = True
    version: int
    runs: tuple[ShownStart, ...]


@dataclass(frozen=True)
class BusyEvent(PageEvent):
    """A long thing goes on: "fit", "diagnose" or "check"; ``began``: seconds since the epoch; ``held``: it was stopped
    and can be resumed."""

    event: ClassVar[str] = "busy"
    kept = True
    what: str
    text: str
    began: float
    held: bool = False


@dataclass(frozen=True)
class IdleEvent(PageEvent):
    """It has ended: "done", "stopped" or "failed"."""

    event: ClassVar[str] = "idle"

    what: str
    end: str
    seconds: float


@dataclass(frozen=True)
class LineEvent(PageEvent):
    """A line of progress, as a terminal prints it; kind: "headline", or "detail" below the last one."""

    event: ClassVar[str] = "told"

    every = True
    text: str
    kind: str

    def as_dict(self) -> Json:
        """Its name on the page is ``message``."""
        return super().as_dict() | {"event": "message"}


@dataclass(frozen=True)
class FailedEvent(PageEvent):
    """What is wrong and what to do, in a sentence, and where."""

    event: ClassVar[str] = "failed"

    text: str
    file: str = ""
    line: int | None = None
    column: str = ""
    during: str = ""


@dataclass(frozen=True)
class ProgressEvent(PageEvent):
    """Where a fit stands: simulations so far, and the lowest point; scores and curves of it come as always."""

    event: ClassVar[str] = "progress"

    iteration: int
    rms: dict[str, float]
    chi2: float
    values: dict[str, float]
    text: str


@dataclass(frozen=True)
class CandidateEvent(PageEvent):
    """A model of a diagnosis as it is tried: state "fitted" or "failed" (``reason``).

    Attributes:
        explained: part of the squared error beyond the noise that it takes away; ``delta_bic`` against the base model.
        rms: of each signal on the fitted runs [shown unit].
        brief: fitted in a few steps only.
    """

    event: ClassVar[str] = "candidate"

    every = True
    effects: tuple[str, ...]
    family: str
    balance: str
    text: str
    explained: float | None
    explained_text: str
    delta_bic: float | None
    rms: dict[str, float]
    brief: bool
    state: str
    reason: str


@dataclass(frozen=True)
class RankingEvent(PageEvent):
    """All models that were fitted, best first: rows of texts as the report has them.

    Each has ``effect``, ``family``, ``balance``, ``place``, ``explained``, ``delta_bic``, ``chi2``, ``holdout``,
    ``own`` and ``added``, and for the page ``effects`` as a list, ``number`` to take it by, and ``share`` and ``bic``
    as numbers.
    """

    event: ClassVar[str] = "ranking"
    kept = True
    candidates: tuple[Json, ...]
    failed: tuple[Json, ...]
    final: bool


@dataclass(frozen=True)
class VerdictEvent(PageEvent):
    """The answer with its reasons, in the words and rows of the report.

    Attributes:
        kind, kind_name, headline, error, reason, probability, meaning, compared, not_tried: sentences.
        probabilities: what may be missing, the most probable first, each with "what", "share" and "named" (by the
            verdict); the last is what no effect describes.
        effects: what was found, to be added. instrument: what is said of an instrument; "": it is physics.
        summary: the error before and after. parameters: fitted, with intervals.
        next: the next experiment, as ``reporting.account.next_run`` has it; None: there is none to make.
        learned: the formula for what no effect explains. missing: what is left in words.
        complete: whether balances and formula are known already.
    """

    event: ClassVar[str] = "verdict"
    kept = True
    kind: str
    kind_name: str
    headline: str
    reason: str
    probability: str
    meaning: str
    families: tuple[str, ...]
    effects: tuple[str, ...]
    error: str = ""
    compared: str = ""
    not_tried: str = ""
    instrument: str = ""
    doubts: tuple[str, ...] = ()
    summary: tuple[Json, ...] = ()
    parameters: tuple[Json, ...] = ()
    next: Json | None = None
    learned: Json | None = None
    missing: Json | None = None
    balance: dict[str, float] | None = None
    equations: str = ""
    complete: bool = False
    probabilities: tuple[Json, ...] = ()


@dataclass(frozen=True)
class LedgerEvent(PageEvent):
    """Which balance fails, in words and as curves.

    Attributes:
        sentence, rows, meanings, readings, notes: as the report has them.
        courses: for each balance ``{"balance", "unit", "runs": [{"run", "time", "term", "low", "high"}], "against":
            [{"name", "unit", "points": [[...], [...]], "at": [...], "mean": [...], "low": [...], "high": [...]}]}``:
            the missing term over time with two standard deviations, and over its variables, as points and as means.
    """

    event: ClassVar[str] = "ledger"
    kept = True
    sentence: str
    rows: tuple[Json, ...]
    meanings: tuple[str, ...]
    readings: tuple[Json, ...]
    notes: tuple[str, ...]
    courses: tuple[Json, ...]


@dataclass(frozen=True)
class NoDiagnosisEvent(PageEvent):
    """The ranking, the verdict and the ledger that were told are no longer those of the study; others may follow."""

    event: ClassVar[str] = "no_diagnosis"


@dataclass(frozen=True)
class CheckEvent(PageEvent):
    """What the data can tell about the model before any fit, as text."""

    event: ClassVar[str] = "checked"
    kept = True
    text: str


@dataclass(frozen=True)
class AddedEvent(PageEvent):
    """A Modelica file was written: its name in the study's folder, and its text."""

    event: ClassVar[str] = "added"
    kept = True
    file: str
    text: str
    effects: tuple[str, ...]


@dataclass(frozen=True)
class SavedEvent(PageEvent):
    """The steps were written to a file of the study's folder; ``time`` in seconds since the epoch."""

    event: ClassVar[str] = "saved"

    file: str
    time: float


@dataclass(frozen=True)
class DroppedFile:
    """A file that was dropped: its first line and some rows below, in cells; none where it is no text."""

    name: str
    bytes: int
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class DroppedEvent(PageEvent):
    """The files that are to become the data set ``folder``."""

    event: ClassVar[str] = "dropped"
    kept = True
    folder: str
    files: tuple[DroppedFile, ...]


@dataclass(frozen=True)
class Excerpt:
    """Rows of a file around one that is wrong: ``first`` is the line of the first of them, ``line`` that of the wrong
    one, ``column`` the number of the cell from 0, where it is known."""

    file: str
    first: int
    line: int
    column: int | None
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@dataclass(frozen=True)
class DraftEvent(PageEvent):
    """What becomes of the dropped files; where that fails, why and where, and of the rest what can be said otherwise:
    title, model, runs, names, parameters and benches as they were last, or none.

    Attributes:
        model: the bench that is proposed. guesses: ``{"what", "taken_as", "why"}`` of each column, run and noise.
        starts: recordings that begin elsewhere than the model by itself, sentences.
        to_check: what only the experimenter knows, likewise.
        names: inputs and outputs of the bench that a column can be taken for. parameters: that may be stated.
        toml: ``experiment.toml`` as it would be written.
        curves: ``{"run", "signal", "unit", "time", "values"}``, a preview.
    """

    event: ClassVar[str] = "draft"
    kept = True
    failed: FailedEvent | None = None
    excerpt: Excerpt | None = None
    title: str = ""
    model: str = ""
    guesses: tuple[Json, ...] = ()
    starts: tuple[str, ...] = ()
    to_check: tuple[str, ...] = ()
    runs: tuple[Json, ...] = ()
    names: tuple[Json, ...] = ()
    parameters: tuple[Json, ...] = ()
    benches: tuple[str, ...] = ()
    toml: str = ""
    curves: tuple[Json, ...] = ()


def answer(number: Any, result: Json | None = None, failed: FailedEvent | None = None) -> str:
    """The message to the window that sent a command with this ``id``."""
    told = None if failed is None else plain_fields(failed)
    return json.dumps(
        {"event": "answer", "id": number, "failed": told, **plain(result or {})}, allow_nan=False
    )
