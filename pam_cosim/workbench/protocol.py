"""What passes between a session and its windows, as data: events, and the binary frames of curves.

A page sends commands, JSON objects such as ``{"id": 7, "do": "set", "values": {"valve.C_A": 0.7}}``; the answer is an
event ``answer`` with that ``id`` and ``failed`` (null, or what went wrong) to the window that sent the command. Every
change is sent to all windows. An event is a JSON object whose key ``event`` is its name. Values are in the shown units
(with their ``unit``), times in seconds; a number that does not exist is null. Records are selected fields of the
products (``selected``).

study: state ("open", or "drop" before there is a data set), title, folder; where it is open also model, short (its last
    name), with_effects, file (that the model was written to), runs, signals, parameters (free), held (all others, with
    source), effects, families, notes, benches, methods (of a fit).
steps: steps, a line ``{"text"}`` each; saved: whether the study was saved as it is.
scores: version, scores (levels by role and signal), runs (rms by run and signal), failed (run and text of
    each that cannot be simulated), ladder (rungs; the last is the standing model), values (of parameters), warnings (of
    the model, each with its runs).
where: version, rules that hold most of the error: signal, rule, error_share, time_share, ranges (of time, by run).
starts: version, runs: run, mode (of ``modes``, or "periodic", "by hand"), text, warning (the model cannot begin there),
    modes, values.
busy: what ("fit", "diagnose", "check"), text, began [s since the epoch], held (it was stopped and can be resumed).
idle: what, end ("done", "stopped", "failed"), seconds.
message: text, kind ("headline", or "detail" below the last headline): a line of progress, as a terminal prints it.
progress: values, text: the lowest point of a fit so far.
failed: text, file, line, column, during (a command or job).
candidate: effects, of the model of a diagnosis that was tried last.
ranking: candidates (rows as the report has them, with effects, share, brief, probability), failed, final.
verdict: kind, kind_name, families, effects, reason, probability, meaning, instrument, probabilities as rows of
    what, probability, named, and the table of families, small; complete: whether the diagnosis has ended,
    with headline, error, compared, disagreement, not_tried, doubts, summary, parameters, next, learned, missing as the
    report has
    them, and found, a rung.
ledger: sentence, rows, meanings, notes as the report has them; courses: missing terms over their variables.
no_diagnosis: ranking, verdict and ledger are no longer those of the study.
checked: text, what the data can determine before any fit.
added: file, text, of the Modelica file that was written.
saved: file.
dropped: files: name, bytes, lines (the first; none where a file is no text).
draft: failed and excerpt (the lines around the wrong one), or both null; title, model, guesses, starts, to_check, runs,
    names, parameters, columns and stated (of experiment.toml), benches, parts (of a bench), toml, curves: the data set
    that the files make, or its errors.

A level of a signal has rms and text; a rung of the ladder has label, fit, holdout
(levels by signal), chi2_fit and chi2_holdout.

A frame of curves is one binary message: the length of a header (unsigned, 4 bytes, little-endian), the header (JSON,
padded with spaces so that what follows begins at a multiple of 4 bytes), then 32-bit floats. The header is
``{"event": "curves", "kind": kind, "version": n, "label": text, "runs": [{"name": run, "from": time, "signals":
[{"name": signal, "n": count, "values_at": place, ...}]}]}``, places in floats. In a frame of kind "measured" a signal
has ``time_at`` too, of all that was recorded, counted from the time that its run has as ``from``: 32 bits hold the time
since 1970 to two minutes only. In a frame of kind "model", "reference" (the model before the last step) or
"found" (by a diagnosis), it has ``residual_at``; one of the last two without runs: there is no such model any more. The
values are those at the times of the measured ones; missing samples, and the model where a run was cut, are NaN. Long
runs are thinned; the answer to the command ``samples`` (run, begin, end) has ``frames`` of a part of a run in base 64,
with every sample where the part is short.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import plain, plain_fields
from pam_cosim.units import readable_factor

Json = dict[str, Any]

DIAGNOSIS = ("ranking", "verdict", "ledger")
KEPT = (
    *("study", "steps", "scores", "where", "starts", "busy"),
    *("checked", "added", "dropped", "draft", *DIAGNOSIS),
)
"""Events of which a window that opens later is sent the last one."""
LINES = ("message", "candidate")
"""Events of which it is sent all since the last job began."""


def event(kind: str, /, **fields: object) -> Json:
    """An event with its fields as plain data."""
    return {"event": kind, **plain(fields)}


def selected(product: object, keys: str, si_unit: str = "", /, **fields: object) -> Json:
    """A record of a message: fields of a product, and others with them.

    Args:
        product: any object.
        keys: of the fields, in the form of ``Plain.json_keys``.
        si_unit: of the fields, if they are quantities: these are converted to the readable unit.
        fields: further fields.
    """
    record = plain_fields(product, keys)
    if si_unit:
        factor = readable_factor(si_unit)
        record = {key: value and value * factor for key, value in record.items()}
    return record | fields


def text_of_message(message: Json) -> str:
    """A message as it is sent."""
    return json.dumps(message, allow_nan=False)


def answer(number: Any, result: Json | None = None, failed: Json | None = None) -> str:
    """The message to the window that sent a command with this ``id``."""
    return text_of_message(event("answer", id=number, failed=failed, **(result or {})))


def failure(problem: BaseException, during: str = "") -> Json:
    """What went wrong, in words, and where; of a file its name alone is sent."""
    column = file = ""
    if isinstance(problem, InputError):
        file = "" if problem.file is None else Path(str(problem.file)).name
        column = "" if problem.column is None else str(problem.column)
        text, line = problem.message, problem.line
    elif isinstance(problem, SimulationFailure):
        text, line = f"the simulation failed: {problem}", None
    else:
        kind = type(problem).__name__
        text, line = f"something went wrong that should not ({kind}: {problem})", None
    return {"text": text, "file": file, "line": line, "column": column, "during": during}
