"""A rig put together from parts, as the Modelica text that a person would write.

What is joined follows from the types alone. The mechanics have one flange for each muscle, and each muscle has
pneumatics of its own. A muscle's end for either is its first connector of that type. An instrument with one connector
sits at that end, one with two lies between the muscle and the part. Inputs of the parts become inputs of the rig,
outputs of the instruments its signals; with several muscles their number is appended. A parameter without a value takes
that of the same name from another part. The frame around the parts is the least that declares what they look for there.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass

from pam_cosim.catalogue.bench_drawing import BenchDrawing, PlacedPart
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
from pam_cosim.compiler import ClassTree, names
from pam_cosim.compiler.class_info import ComponentInfo
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
            raise InputError(
                f"{feed.name}, {hold.name} and {held.name} are parts of different libraries"
            )
        self.taken: set[str] = set()
        self.drawing = BenchDrawing(tree)
        self.ends, outlets = (
            connectors(tree, hold.qualified_name),
            connectors(tree, feed.qualified_name),
        )
        for part, ends in ((hold, self.ends), (feed, outlets)):
            if not ends:
                raise ModelError(f"{part.qualified_name} has no connector for a muscle", part.file)
        self.outlet = outlets[0]
        self.numbers = [0] if len(self.ends) == 1 else list(range(1, len(self.ends) + 1))
        self.inputs = self._inputs()
        self.taken |= set(self.inputs)
        self.measured = self._measured(instruments, measure)
        self.taken |= {signal for signal, _, _ in self.measured}

    # ---- inputs and measured signals ------------------------------------------------------------------------------

    def _inputs(self) -> dict[str, tuple[BenchPart, int, ComponentInfo]]:
        inputs: dict[str, tuple[BenchPart, int, ComponentInfo]] = {}
        sides = (
            [(self.feed, n) for n in self.numbers]
            + [(self.held, n) for n in self.numbers]
            + [(self.hold, 0)]
        )
        for part, number in sides:
            for declared in free_inputs(self.tree, part.qualified_name):
                signal = _numbered(declared.name, number)
                if signal in inputs:
                    raise InputError(
                        f"{part.name} and {inputs[signal][0].name} both have an input '{signal}'"
                    )
                inputs[signal] = (part, number, declared)
        return inputs

    def _measured(
        self, instruments: Sequence[BenchPart], measure: str | Sequence[str] | None
    ) -> list[tuple[str, int, BenchPart]]:
        """Signal, number of the muscle and instrument, in the order requested."""
        measurable = {
            _numbered(signal, n): (n, instrument)
            for instrument in instruments
            for signal in instrument.signals
            for n in self.numbers
        }
        if measure is None:
            usual = [
                s
                for imposed in (*self.feed.signals, *self.hold.signals)
                for s in self._meant(imposed, measurable)
            ]
            signals = dict.fromkeys(signal for signal in usual if signal not in self.inputs)
        else:
            signals = self._wanted(_asked(measure), measurable)
        if not signals:
            raise InputError(
                f"no signal is measured; name signals to measure: {', '.join(measurable)}"
            )
        return [(signal, *measurable[signal]) for signal in signals]

    def _meant(self, signal: str, signals: Container[str]) -> list[str]:
        """A signal by its name, or that of each muscle; empty where there is none."""
        if signal in signals:
            return [signal]
        return [numbered for n in self.numbers if (numbered := _numbered(signal, n)) in signals]

    def _wanted(
        self, requested: Sequence[str], measurable: Mapping[str, object]
    ) -> dict[str, None]:
        """The signals that are requested, each once.

        Raises:
            InputError: there is no such signal, or it is imposed.
        """
        signals: dict[str, None] = {}
        for signal in requested:
            matching_signals = self._meant(signal, measurable)
            if not matching_signals:
                raise InputError(
                    f"the rig has no signal '{signal}' to measure; {did_you_mean(signal, measurable)}"
                )
            signals |= dict.fromkeys(matching_signals)
        imposed = next((signal for signal in signals if signal in self.inputs), None)
        if imposed is not None:
            part = self.inputs[imposed][0].name
            raise InputError(
                f"'{imposed}' is imposed with {part}: it is an input of the rig and is not measured"
            )
        return signals

    # ---- places of the parts ---------------------------------------------------------------------------------------

    def _place(self, part: BenchPart, number: int, corner: tuple[int, int]) -> PlacedPart:
        stem = _numbered(part.component_name, number)
        name, other = stem, 1
        while name in self.taken:
            other += 1
            name = f"{stem}_{other}"
        self.taken.add(name)
        return PlacedPart(part, name, number, corner)

    def rig(self, class_name: str | None) -> ComposedBench:
        """All of it."""
        columns = {n: 320 * i for i, n in enumerate(self.numbers)}
        hold = self._place(self.hold, 0, (30 + 160 * (len(self.numbers) - 1), -160))
        feeds = {n: self._place(self.feed, n, (x - 110, -20)) for n, x in columns.items()}
        muscles = {n: self._place(self.held, n, (x + 30, -20)) for n, x in columns.items()}
        instruments = self._instruments(columns)
        frame = self._frame(
            [self.feed, self.hold, self.held, *(part_placed.part for part_placed in instruments)]
        )
        everything = [*feeds.values(), *muscles.values(), hold, *instruments]
        for part_placed in everything:
            self._component(part_placed, everything)
        for end, number in zip(self.ends, self.numbers, strict=True):
            between = [part_placed for part_placed in instruments if part_placed.number == number]
            self._join(feeds[number], self.outlet, muscles[number], between)
            self._join(hold, end, muscles[number], between)
        instrument_of = {
            (part_placed.part, part_placed.number): part_placed for part_placed in instruments
        }
        for signal, number, part in self.measured:
            self._signal(signal, instrument_of[part, number])
        name = names.identifier(class_name or self._title())
        text = self._text(name, frame, everything)
        inputs = (BRANCH, *self.inputs) if self.static else tuple(self.inputs)
        outputs = tuple(signal for signal, _, _ in self.measured)
        return ComposedBench(
            name,
            text,
            inputs,
            outputs,
            tuple(dict.fromkeys(part_placed.part for part_placed in everything)),
        )

    def _instruments(self, columns: Mapping[int, int]) -> list[PlacedPart]:
        """One of each kind at each muscle, however many signals it reads."""
        placed: list[PlacedPart] = []
        for _, number, part in self.measured:
            if (part, number) not in [
                (instrument.part, instrument.number) for instrument in placed
            ]:
                placed.append(
                    self._place(part, number, self._corner(part, columns[number], placed, number))
                )
        return placed

    def _title(self) -> str:
        """A name made from those of its parts; the usual muscle is not among them."""
        still = "QuasiStatic" if self.static else ""
        muscle_name = "" if self.held.usual else names.last(self.held.qualified_name)
        return f"{still}{names.last(self.feed.qualified_name)}{names.last(self.hold.qualified_name)}{muscle_name}"

    def _corner(
        self, part: BenchPart, x: int, placed: Sequence[PlacedPart], number: int
    ) -> tuple[int, int]:
        """Lower left of an instrument: between the parts, or next to the muscle."""
        (main, *side_connectors) = connectors(self.tree, part.qualified_name)
        at_port = main.type == self.outlet.type
        between = bool(side_connectors)
        corners = {
            (True, True): (x - 50, -20),
            (True, False): (x - 10, -90),
            (False, True): (x + 30, -90),
            (False, False): (x + 100, -60),
        }
        corner = corners[at_port, between]
        while any(
            neighbour.number == number and neighbour.corner == corner for neighbour in placed
        ):
            corner = (corner[0], corner[1] - 60)
        return corner

    def _frame(self, parts: Sequence[BenchPart]) -> str:
        """The least of the frames that declares what the parts look for around them."""
        tree, base = self.tree, f"{self.feed.library}.{FRAME}"
        outer_components = {
            outer for part in parts for outer in _outers(tree, part.qualified_name, set())
        }
        frames = sorted([base, *tree.subtypes(base)], key=lambda name: len(tree.bases(name)))
        for frame in frames:
            if self.static != any(
                c.name == BRANCH and "input" in c.prefixes for c in tree.components(frame)
            ):
                continue
            if surrounds(tree, frame, outer_components):
                return frame
        missing = ", ".join(sorted(name for name, _ in outer_components))
        raise ModelError(
            f"no class that extends {base} declares the outer components of these parts: {missing}"
        )

    # ---- components and connections --------------------------------------------------------------------------------

    def _bindings(
        self, of: str, everything: Sequence[PlacedPart], placed: PlacedPart | None = None
    ) -> list[str]:
        """Values for the parameters of a class that have none, from the parts that have one of that name."""
        bindings = []
        for parameter in (c.name for c in open_parameters(self.tree, of)):
            donors = [
                other for other in everything if other is not placed and self._has(other, parameter)
            ]
            if not donors:
                raise ModelError(
                    f"the parameter {parameter} of {of} has no value, and no other part of the rig has it"
                )
            number = placed.number if placed is not None else 0
            donor = next((other for other in donors if other.number in (0, number)), donors[0])
            bindings.append(f"{parameter}={donor.name}.{parameter}")
        return bindings

    def _has(self, placed: PlacedPart, parameter: str) -> bool:
        return any(
            c.name == parameter for c in known_parameters(self.tree, placed.part.qualified_name)
        )

    def _join(
        self,
        side: PlacedPart,
        end: ComponentInfo,
        muscle: PlacedPart,
        instruments: Sequence[PlacedPart],
    ) -> None:
        """Connects a part with the end of the muscle that has its type, through what lies between."""
        ends = [c for c in connectors(self.tree, muscle.part.qualified_name) if c.type == end.type]
        if not ends:
            raise InputError(
                f"{muscle.part.name} and {side.part.name} do not fit together: no connector accepts '{end.name}'"
            )
        last = muscle_end = (muscle, ends[0])
        for instrument in instruments:
            instrument_connectors = connectors(self.tree, instrument.part.qualified_name)
            if not instrument_connectors or instrument_connectors[0].type != end.type:
                continue
            if len(instrument_connectors) == 1:
                self.drawing.connect(muscle_end, (instrument, instrument_connectors[0]))
            else:
                self.drawing.connect(last, (instrument, instrument_connectors[0]))
                last = (instrument, instrument_connectors[1])
        self.drawing.connect(last, (side, end))

    def _component(self, placed: PlacedPart, everything: Sequence[PlacedPart]) -> None:
        bound = [
            f"{d.name}={s}"
            for s, (part, n, d) in self.inputs.items()
            if (part, n) == (placed.part, placed.number)
        ]
        self.drawing.add(
            placed, [*bound, *self._bindings(placed.part.qualified_name, everything, placed)]
        )

    def _signal(self, signal: str, reader: PlacedPart) -> None:
        outputs = measured_outputs(self.tree, reader.part.qualified_name)
        declared = next(c for c in outputs if _numbered(c.name, reader.number) == signal)
        self.drawing.read(signal, reader, declared)

    def _text(self, name: str, frame: str, everything: Sequence[PlacedPart]) -> str:
        inputs = {signal: declared for signal, (_, _, declared) in self.inputs.items()}
        low = (-190, min(placed.corner[1] for placed in everything) - 20)
        high = (160 + 320 * (len(self.numbers) - 1), 120)
        bindings = self._bindings(frame, everything)
        return self.drawing.text(
            name, frame, bindings, (self.feed, self.hold, self.held), inputs, (low, high)
        )


def _numbered(name: str, number: int) -> str:
    return f"{name}_{number}" if number else name


def _asked(measure: str | Sequence[str]) -> list[str]:
    listed = [measure] if isinstance(measure, str) else measure
    return [name for entry in listed for name in split(entry)]


def _outers(tree: ClassTree, name: str, visited_classes: set[str]) -> set[tuple[str, str]]:
    """Name and class of everything that a class and its components look for around them (Modelica 3.6, section 5.4)."""
    if name in visited_classes or name not in tree.classes:
        return set()
    visited_classes.add(name)
    looked_for: set[tuple[str, str]] = set()
    for component in tree.components(name):
        if "outer" in component.prefixes:
            looked_for.add((component.name, component.type))
        else:
            looked_for |= _outers(tree, component.type, visited_classes)
    return looked_for
