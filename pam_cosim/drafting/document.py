"""``experiment.toml`` as an experienced user would write it, with a remark above every guess."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from textwrap import wrap

from pam_cosim.drafting.benches import Bench
from pam_cosim.drafting.entries import ColumnEntry, Mapped
from pam_cosim.drafting.evidence import Evidence
from pam_cosim.drafting.roles import PointsDraft, Role, Sigma
from pam_cosim.drafting.values import OpenParameters, StatedValue, text_of
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.toml_text import toml_key, toml_string

_WIDTH = 110


@dataclass(frozen=True)
class Draft:
    """The content of the file.

    Attributes:
        bench, mapped: the bench with what was recorded, and the recordings under its names.
        files: names of the copies, one for each recording.
        ignored: names of columns that are not read, and why.
        sigmas: by signals.
        follows: parameters that no file and no user states, with their value and why.
        run_values: by recording, values of parameters and inputs that hold in this recording alone.
        open: which parameters a fit may determine. rated: of these, those about whose size a data sheet says something.
        interpolation: of the inputs of all recordings.
        points: of tables of points at rest.
        valve: what the user states of data sheets of valves; "": nothing.
    """

    title: str
    bench: Bench
    mapped: Mapped
    files: Sequence[str]
    ignored: Mapping[str, str]
    sigmas: Mapping[str, Sigma]
    follows: Mapping[str, tuple[str, str]]
    run_values: Sequence[Mapping[str, StatedValue]]
    open: OpenParameters
    roles: Sequence[Role]
    interpolation: str = "linear"
    points: PointsDraft | None = None
    valve: str = ""
    rated: Collection[str] = ()

    @property
    def free(self) -> dict[str, Variable]:
        """What a fit moves, with its bounds: no data sheet states what a jet leaves of an area."""
        free = self.open.free.items()
        return {n: v for n, v in free if n in self.rated or not self.is_known(n)}

    @property
    def interface(self) -> Interface:
        """Of the bench."""
        return self.bench.interface

    @property
    def evidence(self) -> Evidence:
        """What was recorded."""
        return self.bench.evidence

    @property
    def recordings(self) -> list[str]:
        """Each recording by its file, and the part that it is of that."""
        named = zip(self.files, self.evidence.sources, strict=True)
        return [f if s.part is None else f"{f}, part {s.part.number}" for f, s in named]

    @property
    def unfed(self) -> list[str]:
        """Inputs without a value in some recording."""
        return [n for n in self.bench.choice.unfed if not self.is_known(n)]

    def is_known(self, name: str) -> bool:
        """Whether a parameter or an input has a value in every recording."""
        has_value = name in self.evidence.stated or name in self.follows
        return has_value or all(name in run for run in self.run_values)

    def having(self, name: str) -> list[int]:
        """The recordings that have the column of a signal, if only empty."""
        column = self.bench.choice.fed.get(name)
        all_recordings = range(len(self.files))
        return sorted(column.places) if column is not None else [*all_recordings]


def document(draft: Draft) -> str:
    """The text."""
    blocks = [
        _head(draft),
        _recording(draft),
        _columns(draft),
        _signals(draft),
        _parameters(draft),
        _fit(draft),
    ]
    blocks += [_run(draft, i) for i in range(len(draft.files))]
    return "\n\n".join("\n".join(lines) for block in blocks if (lines := list(block))) + "\n"


def remark(text: str) -> list[str]:
    """Lines of a comment; what does not print is left out, so that no text of a file ends it."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    return [f"# {line}" for line in wrap(plain, _WIDTH)]


def _guessed(what: str, why: str) -> list[str]:
    return remark(f"guessed: {what}, because {why}" if what else f"guessed: {why}")


def _head(draft: Draft) -> Iterator[str]:
    yield from remark(
        "Drafted by pam-cosim new. Every guess is marked; check it and remove the mark."
    )
    yield f"title = {toml_string(draft.title)}"
    yield from remark(draft.bench.why)
    yield f"model = {toml_string(draft.bench.name)}"
    if draft.points is not None:
        yield from _guessed(
            "", "these are points at rest, for no column is a time: each row is an equilibrium"
        )
        yield 'kind = "static"'


def _recording(draft: Draft) -> Iterator[str]:
    stated = _stated_of_files(draft)
    ignored = draft.ignored
    if not stated and not ignored:
        return
    yield "[recording]"
    for name, value in stated.items():
        yield f"{name} = {_setting(name, value)}"
    for name, why in ignored.items():
        yield from remark(f"not read: {name}, {why}")
    if ignored:
        yield f"ignore = {_texts(ignored)}"


def _stated_of_files(draft: Draft) -> dict[str, object]:
    """What is stated of the layout of the files, except the columns that are not read."""
    stated = draft.evidence.recording.model_dump(exclude_none=True, exclude_unset=True)
    stated.pop("ignore", None)
    return stated


def _setting(key: str, value: object) -> str:
    """A value of ``[recording]``; a word or a name is a text, also where it looks like a number."""
    if isinstance(value, list):
        return _texts(value)
    return toml_string(value) if isinstance(value, str) and key != "interval" else _value(value)


def _texts(values: Iterable[str]) -> str:
    return f"[{', '.join(map(toml_string, values))}]"


def _columns(draft: Draft) -> Iterator[str]:
    entries = draft.mapped.entries.values()
    shared = [entry for entry in entries if not _own(draft, entry) and _is_needed(entry)]
    if shared:
        yield "[columns]"
    for entry in shared:
        yield from _entry(entry, next(iter(entry.zero.values()), None))


def _own(draft: Draft, entry: ColumnEntry) -> bool:
    """Whether the entry differs between recordings, or is of some only."""
    having, zeros = draft.having(entry.name), set(entry.zero.values())
    differs = len(zeros) > 1 or (bool(zeros) and len(entry.zero) < len(having))
    return len(having) < len(draft.files) or differs


def _is_needed(entry: ColumnEntry) -> bool:
    """Whether the column has another name, unit, sign or zero than the bench."""
    renamed = entry.column is not None and entry.column != entry.name
    return bool(renamed or entry.unit or entry.formula or entry.zero or entry.words or entry.gain)


def _entry(entry: ColumnEntry, zero: tuple[float, float] | None) -> Iterator[str]:
    if entry.why:
        yield from _guessed(
            f"{entry.name} is {entry.column or entry.formula}", "; ".join(entry.why)
        )
    cells = []
    if entry.formula is not None:
        cells.append(f"formula = {toml_string(entry.formula)}")
    elif entry.column is not None and entry.column != entry.name:
        cells.append(f"column = {toml_string(entry.column)}")
    if entry.unit and entry.formula is None:
        cells.append(f"unit = {toml_string(entry.unit)}")
    for key, value in (("gain", entry.gain), ("offset", entry.offset)):
        if value is not None:
            cells.append(f"{key} = {toml_string(value)}")
    if entry.words:
        words = ", ".join(
            f"{toml_key(word)} = {toml_string(way)}" for word, way in entry.words.items()
        )
        cells.append(f"words = {{ {words} }}")
    if zero is not None:
        start, stop = map(_seconds, zero)
        cells.append(f'zero = {{ from = "{start}", to = "{stop}" }}')
    yield f"{toml_key(entry.name)} = {{ {', '.join(cells)} }}"


def _seconds(time: float) -> str:
    """A time without needless digits."""
    return f"{time:.6f}".rstrip("0").rstrip(".") + " s"


def _signals(draft: Draft) -> Iterator[str]:
    for name, sigma in draft.sigmas.items():
        yield f"[signals.{toml_key(name)}]"
        if sigma.value is None:
            yield from remark(f"sigma is left out: {sigma.why}")
            continue
        yield from _guessed("sigma", f"it is {sigma.why}")
        yield f"sigma = {_quantity(sigma.value, draft.interface.outputs[name].unit, 3)}"


def _parameters(draft: Draft) -> Iterator[str]:
    inputs = {n: draft.interface.inputs[n] for n in draft.unfed}
    unstated = {n: v for n, v in draft.open.to_state.items() if not draft.is_known(n)}
    if not (draft.evidence.stated or draft.follows or inputs or unstated):
        return
    yield "[parameters]"
    for name, value in draft.evidence.stated.items():
        yield f"{toml_string(name)} = {_value(value)}"
    reason = ""
    for name, (value, why) in draft.follows.items():
        if why != reason:
            yield from remark(why)
        reason = why
        yield f"{toml_string(name)} = {_value(value)}"
    for name, variable in inputs.items():
        yield from remark(
            "no column was recognised as this input: the bench's default is used until you state yours"
        )
        yield _commented(name, variable)
    if unstated:
        yield from remark(
            "The bench's own values, not those of your rig: state yours, above all geometry and load."
        )
    for name, variable in unstated.items():
        yield _commented(name, variable)


def _commented(name: str, variable: Variable) -> str:
    description = " ".join(remark(variable.description)).removeprefix("# ")
    value = _quantity(variable.start or 0.0, variable.unit, 6)
    return f"# {toml_string(name)} = {value}   # {description}: state yours"


def _fit(draft: Draft) -> Iterator[str]:
    free, of_runs = draft.free, {n for run in draft.run_values for n in run}
    free = {n: v for n, v in free.items() if n not in of_runs}
    more = {
        n: v for n, v in draft.open.perhaps.items() if n not in of_runs and not draft.is_known(n)
    }
    if not free and not more:
        return
    yield "[fit]"
    if free:
        what = "of the muscle's wall" if draft.points else "that are not calibrated"
        yield from _guessed(
            "",
            f"free are the parameters {what}: only a fit determines them; bounds are the model's or near its values",
        )
    for name, variable in free.items():
        yield f"{bounds(name, variable)}   {' '.join(remark(variable.description))}"
    if more:
        yield from remark("more that may be left free:")
    for name, variable in more.items():
        yield f"# {bounds(name, variable)}   {' '.join(remark(variable.description))}"


def bounds(name: str, variable: Variable) -> str:
    """An entry of [fit]."""
    low, high = (
        _quantity(limit or 0.0, variable.unit, 6) for limit in (variable.min, variable.max)
    )
    return f"{toml_string(name)} = {{ min = {low}, max = {high} }}"


def _run(draft: Draft, i: int) -> Iterator[str]:
    yield "[[runs]]"
    yield f"file = {toml_string(draft.files[i])}"
    role, part = draft.roles[i], draft.evidence.sources[i].part
    if role.why:
        yield from _guessed("held out", role.why)
    yield f'role = "{role.role}"'
    if draft.points is None and draft.interpolation != "linear":
        yield from _guessed("inputs keep their value until the next sample", "they step and stay")
        yield f'interpolation = "{draft.interpolation}"'
    if part is not None:
        yield from _guessed(
            f"this is experiment {part.number} of the file", "the time goes back to its beginning"
        )
        yield 'gaps = "split"'
        for key, at in (("from", part.begin), ("to", part.end)):
            if at is not None:
                yield f'{key} = "{_seconds(at)}"'
    if draft.points is not None:
        yield from _points(draft.points, i)
    values = draft.run_values[i]
    if values:
        yield "[runs.parameters]"
    for name, value in values.items():
        if value.why:
            yield from _guessed(name, value.why)
        yield f"{toml_string(name)} = {_value(value.value)}"
    having = [e for e in draft.mapped.entries.values() if i in draft.having(e.name)]
    entries = [entry for entry in having if _own(draft, entry) and _is_needed(entry)]
    if entries:
        yield "[runs.columns]"
    for entry in entries:
        yield from _entry(entry, entry.zero.get(i))


def _points(points: PointsDraft, i: int) -> Iterator[str]:
    """Direction and rows that are held out, of a table of points at rest."""
    if points.branch[i]:
        if points.branch[i] == "order":
            yield from _guessed(
                "branch", "the rows go up and come back: their order gives the direction of each"
            )
        yield f"branch = {toml_string(points.branch[i])}"
    if points.hold_out[i]:
        yield from _guessed("", "rows that are held out lie within the range of the fitted ones")
        values = ", ".join(
            f"{toml_key(name)} = {_value(list(v))}" for name, v in points.hold_out[i].items()
        )
        yield f"hold_out = {{ {values} }}"


def _quantity(value: float, unit: str, digits: int) -> str:
    return _value(text_of(float(f"{value:.{digits}g}"), unit))


def _value(value: object) -> str:
    """A TOML value; what is a plain number stands without quotes."""
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, int):
        return str(value)
    text = str(value)
    try:
        is_number = text.strip()[:1].isdigit() or text.strip()[:1] in "-.+"
        return f"{float(text):.12g}" if is_number else toml_string(text)
    except ValueError:
        return toml_string(text)
