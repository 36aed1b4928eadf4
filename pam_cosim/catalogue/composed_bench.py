"""A rig put together from parts, as the Modelica text that a person would write.

What is joined follows from the types alone. The mechanics have one flange for each muscle, and each muscle has
pneumatics of its own. A muscle's end for either is its first connector of that type. An instrument with one connector
sits at that end, one with two lies between the muscle and the part. Inputs of the parts become inputs of the rig,
outputs of the instruments its signals; with several muscles their number is appended. A parameter without a value takes
that of the same name from another part. The frame around the parts is the least that declares what they look for there.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from html import escape

from pam_cosim.catalogue.bench_parts import (
    FRAME,
    BenchPart,
    chosen,
    connectors,
    free_inputs,
    known_parameters,
    measured_outputs,
    open_parameters,
    rig_parts,
    split,
)
from pam_cosim.catalogue.place import surrounds
from pam_cosim.catalogue.rig_signals import declarations
from pam_cosim.compiler import ClassTree, names
from pam_cosim.compiler.class_tree import ComponentInfo
from pam_cosim.compiler.printing import string_text
from pam_cosim.errors import InputError, ModelError
from pam_cosim.model.references import BRANCH
from pam_cosim.wording import did_you_mean


@dataclass(frozen=True)
class ComposedBench:
    """A rig put together.

    Attributes:
        name: of the class.
        text: Modelica source of the class.
        inputs, outputs: names of its signals.
        parts: what it was put together from.
    """

    name: str
    text: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    parts: tuple[BenchPart, ...]


@dataclass(frozen=True)
class _Placed:
    """A part under the name that it has in the rig; ``number`` is that of its muscle, zero for what all share."""

    part: BenchPart
    name: str
    number: int
    corner: tuple[int, int]


_End = tuple[_Placed, ComponentInfo]
_Point = tuple[float, float]
_HALF = 20  # of the width of a part in the diagram
_CLEAR = 15  # below what stands side by side, for a line across


@dataclass
class _Draft:
    """The lines of a rig."""

    outputs: dict[str, ComponentInfo] = field(default_factory=dict)
    components: list[str] = field(default_factory=list)
    equations: list[str] = field(default_factory=list)


def compose_bench(
    tree: ClassTree,
    pneumatics: str,
    mechanics: str,
    muscle: str | None = None,
    measure: str | Sequence[str] | None = None,
    name: str | None = None,
    static: bool = False,
) -> ComposedBench:
    """The rig of two sides, of muscles between them, and of instruments.

    Args:
        tree: the library and the user's files.
        pneumatics: what feeds each muscle, by its name in ``rig_parts``.
        mechanics: what holds their load ends.
        muscle: default: the library's usual one.
        measure: signals that are read, such as "p, x_1"; with several muscles "x" is that of each. Default: what is
            usual with these parts.
        name: of the new class; default: made from the names.
        static: it is measured at rest, point by point: its frame has an input for the direction of a branch.

    Raises:
        InputError: an unknown part or signal; parts that do not fit together.
    """
    parts = rig_parts(tree)
    feed, hold, held = (
        chosen(parts, "pneumatics", pneumatics),
        chosen(parts, "mechanics", mechanics),
        chosen(parts, "muscle", muscle),
    )
    instruments = [p for p in parts if p.role == "instrument" and p.library == feed.library]
    return _Composer(tree, feed, hold, held, instruments, measure, static).rig(name)


class _Composer:
    def __init__(
        self,
        tree: ClassTree,
        feed: BenchPart,
        hold: BenchPart,
        held: BenchPart,
        instruments: Sequence[BenchPart],
        measure: str | Sequence[str] | None,
        static: bool,
    ) -> None:
        self.static = static
        self.tree, self.feed, self.hold, self.held = tree, feed, hold, held
        if len({part.library for part in (feed, hold, held)}) > 1:
            raise InputError(f"{feed.name}, {hold.name} and {held.name} are parts of different libraries")
        self.taken: set[str] = set()
        self.draft = _Draft()
        self.ends, outlets = connectors(tree, hold.qualified_name), connectors(tree, feed.qualified_name)
        for part, ends in ((hold, self.ends), (feed, outlets)):
            if not ends:
                raise ModelError(f"{part.qualified_name} has no connector for a muscle", part.file)
        self.outlet = outlets[0]
        self.numbers = [0] if len(self.ends) == 1 else list(range(1, len(self.ends) + 1))
        self.inputs = self._inputs()
        self.taken |= set(self.inputs)
        self.measured = self._measured(instruments, measure)
        self.taken |= {signal for signal, _, _ in self.measured}

    # ---- what is told and what is read --------------------------------------------------------------------------

    def _inputs(self) -> dict[str, tuple[BenchPart, int, ComponentInfo]]:
        inputs: dict[str, tuple[BenchPart, int, ComponentInfo]] = {}
        sides = [(self.feed, n) for n in self.numbers] + [(self.held, n) for n in self.numbers] + [(self.hold, 0)]
        for part, number in sides:
            for declared in free_inputs(self.tree, part.qualified_name):
                signal = _numbered(declared.name, number)
                if signal in inputs:
                    raise InputError(f"{part.name} and {inputs[signal][0].name} both have an input '{signal}'")
                inputs[signal] = (part, number, declared)
        return inputs

    def _measured(
        self, instruments: Sequence[BenchPart], measure: str | Sequence[str] | None
    ) -> list[tuple[str, int, BenchPart]]:
        """Signal, number of the muscle and instrument, in the order asked for."""
        known = {
            _numbered(signal, n): (n, instrument)
            for instrument in instruments
            for signal in instrument.signals
            for n in self.numbers
        }
        if measure is None:
            usual = [s for one in (*self.feed.signals, *self.hold.signals) for s in self._meant(one, known)]
            wanted = dict.fromkeys(signal for signal in usual if signal not in self.inputs)
        else:
            wanted = self._wanted(_asked(measure), known)
        if not wanted:
            raise InputError(f"the rig measures nothing; name signals to measure: {', '.join(known)}")
        return [(signal, *known[signal]) for signal in wanted]

    def _meant(self, signal: str, known: Container[str]) -> list[str]:
        """A signal by its name, or that of each muscle; empty where there is none."""
        if signal in known:
            return [signal]
        return [one for n in self.numbers if (one := _numbered(signal, n)) in known]

    def _wanted(self, asked: Sequence[str], known: Mapping[str, object]) -> dict[str, None]:
        """The signals that are asked for, each once.

        Raises:
            InputError: there is no such signal, or it is imposed.
        """
        wanted: dict[str, None] = {}
        for signal in asked:
            meant = self._meant(signal, known)
            if not meant:
                raise InputError(f"the rig has no signal '{signal}' to measure; {did_you_mean(signal, known)}")
            wanted |= dict.fromkeys(meant)
        imposed = next((signal for signal in wanted if signal in self.inputs), None)
        if imposed is not None:
            part = self.inputs[imposed][0].name
            raise InputError(f"'{imposed}' is imposed with {part}: it is an input of the rig and is not measured")
        return wanted

    # ---- what stands where --------------------------------------------------------------------------------------

    def _place(self, part: BenchPart, number: int, corner: tuple[int, int]) -> _Placed:
        wanted = _numbered(part.component_name, number)
        name, other = wanted, 1
        while name in self.taken:
            other += 1
            name = f"{wanted}_{other}"
        self.taken.add(name)
        return _Placed(part, name, number, corner)

    def rig(self, wanted: str | None) -> ComposedBench:
        """All of it."""
        columns = {n: 320 * i for i, n in enumerate(self.numbers)}
        hold = self._place(self.hold, 0, (30 + 160 * (len(self.numbers) - 1), -160))
        feeds = {n: self._place(self.feed, n, (x - 110, -20)) for n, x in columns.items()}
        muscles = {n: self._place(self.held, n, (x + 30, -20)) for n, x in columns.items()}
        instruments = self._instruments(columns)
        frame = self._frame([self.feed, self.hold, self.held, *(one.part for one in instruments)])
        everything = [*feeds.values(), *muscles.values(), hold, *instruments]
        for one in everything:
            self._component(one, everything)
        for end, number in zip(self.ends, self.numbers, strict=True):
            between = [one for one in instruments if one.number == number]
            self._join(feeds[number], self.outlet, muscles[number], between)
            self._join(hold, end, muscles[number], between)
        instrument_of = {(one.part, one.number): one for one in instruments}
        for signal, number, part in self.measured:
            self._signal(signal, instrument_of[part, number])
        name = names.identifier(wanted or self._title())
        text = self._text(name, frame, everything)
        inputs = (BRANCH, *self.inputs) if self.static else tuple(self.inputs)
        outputs = tuple(signal for signal, _, _ in self.measured)
        return ComposedBench(name, text, inputs, outputs, tuple(dict.fromkeys(one.part for one in everything)))

    def _instruments(self, columns: Mapping[int, int]) -> list[_Placed]:
        """One of each kind at each muscle, however many signals it reads."""
        placed: list[_Placed] = []
        for _, number, part in self.measured:
            if (part, number) not in [(one.part, one.number) for one in placed]:
                placed.append(self._place(part, number, self._corner(part, columns[number], placed, number)))
        return placed

    def _title(self) -> str:
        """A name made from those of its parts; the usual muscle is not among them."""
        still = "QuasiStatic" if self.static else ""
        own = "" if self.held.usual else names.last(self.held.qualified_name)
        return f"{still}{names.last(self.feed.qualified_name)}{names.last(self.hold.qualified_name)}{own}"

    def _corner(self, part: BenchPart, x: int, placed: Sequence[_Placed], number: int) -> tuple[int, int]:
        """Lower left of an instrument: between the parts, or beside the muscle."""
        (first, *others) = connectors(self.tree, part.qualified_name)
        at_port = first.type == self.outlet.type
        between = bool(others)
        corners = {
            (True, True): (x - 50, -20),
            (True, False): (x - 10, -90),
            (False, True): (x + 30, -90),
            (False, False): (x + 100, -60),
        }
        corner = corners[at_port, between]
        while any(one.number == number and one.corner == corner for one in placed):
            corner = (corner[0], corner[1] - 60)
        return corner

    def _frame(self, parts: Sequence[BenchPart]) -> str:
        """The least of the frames that declares what the parts look for around them."""
        tree, base = self.tree, f"{self.feed.library}.{FRAME}"
        needed = {outer for part in parts for outer in _outers(tree, part.qualified_name, set())}
        frames = sorted([base, *tree.subtypes(base)], key=lambda name: len(tree.bases(name)))
        for frame in frames:
            if self.static != any(c.name == BRANCH and "input" in c.prefixes for c in tree.components(frame)):
                continue
            if surrounds(tree, frame, needed):
                return frame
        missing = ", ".join(sorted(name for name, _ in needed))
        raise ModelError(f"no class that extends {base} declares what these parts look for around them: {missing}")

    # ---- lines --------------------------------------------------------------------------------------------------

    def _component(self, one: _Placed, everything: Sequence[_Placed]) -> None:
        bound = [f"{d.name}={s}" for s, (part, n, d) in self.inputs.items() if (part, n) == (one.part, one.number)]
        bound += self._bindings(one.part.qualified_name, everything, one)
        modifier = f"({', '.join(bound)})" if bound else ""
        (x, y) = one.corner
        place = f"annotation (Placement(transformation(extent={{{{{x},{y}}},{{{x + 2 * _HALF},{y + 2 * _HALF}}}}})))"
        says = string_text(one.part.description)
        self.draft.components.append(f"{one.part.qualified_name} {one.name}{modifier} {says}\n    {place}")

    def _bindings(self, of: str, everything: Sequence[_Placed], one: _Placed | None = None) -> list[str]:
        """Values for the parameters of a class that have none, from the parts that have one of that name."""
        bindings = []
        for parameter in (c.name for c in open_parameters(self.tree, of)):
            donors = [other for other in everything if other is not one and self._has(other, parameter)]
            if not donors:
                raise ModelError(f"the parameter {parameter} of {of} has no value, and no other part of the rig has it")
            number = one.number if one is not None else 0
            donor = next((other for other in donors if other.number in (0, number)), donors[0])
            bindings.append(f"{parameter}={donor.name}.{parameter}")
        return bindings

    def _has(self, one: _Placed, parameter: str) -> bool:
        return any(c.name == parameter for c in known_parameters(self.tree, one.part.qualified_name))

    def _join(self, side: _Placed, end: ComponentInfo, muscle: _Placed, instruments: Sequence[_Placed]) -> None:
        """Connects a part with the end of the muscle that has its type, through what lies between."""
        ends = [c for c in connectors(self.tree, muscle.part.qualified_name) if c.type == end.type]
        if not ends:
            raise InputError(f"{muscle.part.name} and {side.part.name} do not fit together: nothing takes '{end.name}'")
        last = muscle_end = (muscle, ends[0])
        for instrument in instruments:
            own = connectors(self.tree, instrument.part.qualified_name)
            if not own or own[0].type != end.type:
                continue
            if len(own) == 1:
                self._connect(muscle_end, (instrument, own[0]))
            else:
                self._connect(last, (instrument, own[0]))
                last = (instrument, own[1])
        self._connect(last, (side, end))

    def _connect(self, one: _End, other: _End) -> None:
        joined = ", ".join(f"{placed.name}.{connector.name}" for placed, connector in (one, other))
        points = ", ".join(f"{{{x:g},{y:g}}}" for x, y in _line(one, other))
        self.draft.equations.append(f"connect({joined})\n    annotation (Line(points={{{points}}}))")

    def _signal(self, signal: str, reader: _Placed) -> None:
        declared = next(
            c
            for c in measured_outputs(self.tree, reader.part.qualified_name)
            if _numbered(c.name, reader.number) == signal
        )
        self.draft.outputs[signal] = declared
        self.draft.equations.append(f"{signal} = {reader.name}.{declared.name}")

    def _text(self, name: str, frame: str, everything: Sequence[_Placed]) -> str:
        draft = self.draft
        low = (-190, min(one.corner[1] for one in everything) - 20)
        high = (160 + 320 * (len(self.numbers) - 1), 120)
        imposed = {signal: declared for signal, (_, _, declared) in self.inputs.items()}
        inputs = declarations(self.tree, "input", imposed, low, high)
        outputs = declarations(self.tree, "output", draft.outputs, low, high)
        says = "; ".join([self.hold.description, *map(_lower, (self.feed.description, self.held.description))])
        bindings = self._bindings(frame, everything)
        lines = [f"model {name} {string_text(says)}"]
        lines.append(f"  extends {frame}({', '.join(bindings)});" if bindings else f"  extends {frame};")
        lines += [f"  {line};" for line in (*inputs, *outputs, *draft.components)]
        lines += ["equation", *(f"  {line};" for line in draft.equations)]
        experiment = self.tree.classes[frame].annotations.get("experiment")
        info = string_text("\n".join(self._documentation()))
        extent = f"{{{{{low[0]},{low[1]}}},{{{high[0]},{high[1]}}}}}"
        diagram = f"Diagram(coordinateSystem(preserveAspectRatio=true, extent={extent}))"
        notes = ",\n    ".join(filter(None, (diagram, experiment, f"Documentation(info={info})")))
        return "\n".join([*lines, f"  annotation ({notes});", f"end {name};", ""])

    def _documentation(self) -> Iterator[str]:
        yield "<html>"
        yield "".join(f"<p>{escape(part.description)}.</p>" for part in (self.feed, self.hold, self.held))
        yield "<ul>"
        for signal, (_, _, declared) in self.inputs.items():
            yield f"<li>input <code>{escape(signal)}</code>: {escape(declared.description)}</li>"
        for signal, declared in self.draft.outputs.items():
            yield f"<li>output <code>{escape(signal)}</code>: {escape(declared.description)}</li>"
        yield "</ul>"
        used = ", ".join(f"<code>{escape(p.qualified_name)}</code>" for p in (self.feed, self.hold, self.held))
        yield f"<p>Equations and sources: {used}.</p>"
        yield "</html>"


def _line(one: _End, other: _End) -> list[_Point]:
    """Corners of a line between two connectors, level and upright, that leaves each away from its part."""
    (a, a_up), (b, b_up) = _exit(one), _exit(other)
    if a_up and b_up:
        across = min(a[1], b[1]) + _CLEAR
        points = [a, (a[0], across), (b[0], across), b]
    elif a_up:
        points = [a, (a[0], b[1]), b]
    elif b_up:
        points = [a, (b[0], a[1]), b]
    else:
        middle = (a[0] + b[0]) / 2
        points = [a, (middle, a[1]), (middle, b[1]), b]
    return [a, b] if a[0] == b[0] or a[1] == b[1] else points


def _exit(end: _End) -> tuple[_Point, bool]:
    """Where a connector stands in the diagram, and whether it is at the top or the bottom of its part."""
    placed, connector = end
    x, y = connector.position or (0.0, 0.0)
    left, low = placed.corner
    return (left + _HALF * (1 + x / 100), low + _HALF * (1 + y / 100)), abs(y) > abs(x)


def _numbered(name: str, number: int) -> str:
    return f"{name}_{number}" if number else name


def _asked(measure: str | Sequence[str]) -> list[str]:
    listed = [measure] if isinstance(measure, str) else measure
    return [name for one in listed for name in split(one)]


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:]


def _outers(tree: ClassTree, name: str, seen: set[str]) -> set[tuple[str, str]]:
    """Name and class of everything that a class and its components look for around them (Modelica 3.6, section 5.4)."""
    if name in seen or name not in tree.classes:
        return set()
    seen.add(name)
    looked_for: set[tuple[str, str]] = set()
    for component in tree.components(name):
        if "outer" in component.prefixes:
            looked_for.add((component.name, component.type))
        else:
            looked_for |= _outers(tree, component.type, seen)
    return looked_for
