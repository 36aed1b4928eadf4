"""The bench of a new data set: the one that the user names, a ready one, or one that is put together from parts."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.catalogue.bench_parts import rig_parts
from pam_cosim.catalogue.composed_bench import compose_bench
from pam_cosim.catalogue.ports import Ports, ports
from pam_cosim.compiler import ClassTree
from pam_cosim.drafting.bench_choice import choose
from pam_cosim.drafting.feeding import MECHANICAL, BenchChoice, meaning_of
from pam_cosim.drafting.file_names import Muscle, muscle_in
from pam_cosim.drafting.folder import copy_files
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.requests import DraftRequests, ReadRecordings
from pam_cosim.drafting.zeros import NO_PRESSURE
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import BRANCH, is_file
from pam_cosim.units import convert
from pam_cosim.units.grammar import STANDARD_ATMOSPHERE
from pam_cosim.wording import listed

_SUFFIX = "Rig"


@dataclass(frozen=True)
class Bench:
    """A bench and what feeds it.

    Attributes:
        name: as ``experiment.toml`` has it.
        why: empty where the user says so.
        muscle: of which the files or their names tell.
        usual: its muscle is the usual one, for nobody says another.
    """

    choice: BenchChoice
    name: str
    interface: Interface
    why: str
    muscle: Muscle | None = None
    usual: bool = False


def take_bench(
    place: Path,
    name: str,
    wishes: DraftRequests,
    known: ReadRecordings,
    tree: ClassTree,
    describe: Callable[[str], Interface],
) -> Bench:
    """The bench that the user names, or the one that fits best; what is written for it goes into ``place``.

    Args:
        place: the folder that becomes the data set.
        name: of a class that is put together.
        wishes, known: what the user says and what was recorded.
        tree: the library and the user's files.
        describe: gives the interface of a model.

    Raises:
        InputError: there is no such bench, or none that the recordings feed.
    """
    suited = [_suited(one, known.points) for one in ports(tree)]
    ready = [one for one in suited if one is not None]
    if _is_there_already(wishes, ready):
        return _named(place, str(wishes.model), known, describe)
    recorded = _recorded_muscle(wishes, known, tree)
    muscle = wishes.muscle if recorded is None else recorded.name
    choice = choose(
        _candidates(_possible(ready, known, tree), wishes.model, muscle, known.points),
        known.columns,
        known.asked,
        known.formulas,
        len(known.sources),
        _stated_inputs(known),
    )
    if choice.ports.parts:
        return _put_together(
            place / f"{name}.mo", choice, muscle, recorded, wishes, known, tree, describe
        )
    return Bench(choice, choice.ports.name, describe(choice.ports.name), _why(choice), None, True)


def _is_there_already(wishes: DraftRequests, ready: Sequence[Ports]) -> bool:
    """Whether the user names a bench that is not put together from parts.

    Raises:
        InputError: and names a muscle besides.
    """
    composed = {one.name for one in ready if one.parts}
    if wishes.model is None or wishes.model in composed:
        return False
    if wishes.muscle is not None:
        raise InputError(
            f"a muscle is named for a bench that is put together, and {wishes.model} is there already"
        )
    return True


def _candidates(
    ready: Sequence[Ports], model: str | None, muscle: str | None, points: bool
) -> list[Ports]:
    """The benches among which the recordings choose; only one that is put together can have another muscle."""
    if model is not None:
        return [one for one in ready if one.parts and one.name == model]
    chosen = [one for one in ready if one.parts or muscle is None]
    return [one for one in chosen if _all_imposed(one)] if points else chosen


def _possible(ready: Sequence[Ports], known: ReadRecordings, tree: ClassTree) -> list[Ports]:
    """The benches without those in which everything is shut, where a pressure falls to that outside."""
    if not any(c.of("pressure") and _empties(c) for c in known.columns):
        return list(ready)
    return [one for one in ready if one.parts or one.inputs or _is_open(one, tree)]


def _empties(column: RecordedColumn) -> bool:
    """Whether a pressure falls in every recording from its largest to next to none."""
    outside = STANDARD_ATMOSPHERE if column.absolute else 0.0
    ends = []
    for values in column.values.values():
        gauge = convert(values[np.isfinite(values)], column.unit, "Pa") - outside
        least = NO_PRESSURE * float(gauge.max())
        ends.append(gauge[0] > gauge[-1] and abs(float(gauge[-1])) <= least)
    return bool(column.unit) and all(ends)


def _is_open(one: Ports, tree: ClassTree) -> bool:
    """Whether a bench has a way to the air outside."""
    return any(c.type.rpartition(".")[2] == "Atmosphere" for c in tree.components(one.name))


def _put_together(
    file: Path,
    choice: BenchChoice,
    muscle: str | None,
    recorded: Muscle | None,
    wishes: DraftRequests,
    known: ReadRecordings,
    tree: ClassTree,
    describe: Callable[[str], Interface],
) -> Bench:
    """The bench that is put together from parts, written to a file."""
    file.write_text(
        _composed(choice, file.stem, known, tree, muscle), encoding="utf-8", newline="\n"
    )
    made = _origin(file.name, choice, recorded)
    why = made if wishes.model else f"{_why(choice)}. {made}"
    return Bench(choice, file.name, describe(str(file)), why, recorded, muscle is None)


def _origin(file: str, choice: BenchChoice, recorded: Muscle | None) -> str:
    """What a bench was put together from."""
    made = f"{file} was put together from {choice.ports.name}"
    if recorded is None:
        return made
    return f"{made}, with the muscle {recorded.name}, of which the files or their names tell"


def _recorded_muscle(
    wishes: DraftRequests, known: ReadRecordings, tree: ClassTree
) -> Muscle | None:
    """The muscle that files or their names tell of, where the user names neither one nor a bench."""
    if wishes.muscle is not None or wishes.model is not None:
        return None
    said = [" ".join([source.file.stem, *source.labels]) for source in known.sources]
    return muscle_in(said, [part.name for part in rig_parts(tree) if part.role == "muscle"])


def _stated_inputs(known: ReadRecordings) -> list[str]:
    """Inputs whose values the user states, of all recordings or of some; a name with a dot is a parameter's."""
    every = dict.fromkeys([*known.stated, *(name for own in known.own for name in own)])
    return [name for name in every if "." not in name]


def _why(choice: BenchChoice) -> str:
    fed = listed(f"{one} = {column.name}" for one, column in choice.fed.items())
    why = f"guessed: the bench, because it takes and shows what was recorded: {fed}"
    return f"{why}. Others would do: {listed(choice.others)}" if choice.others else why


def _composed(
    choice: BenchChoice, name: str, known: ReadRecordings, tree: ClassTree, muscle: str | None
) -> str:
    """The Modelica text of a bench that is put together, with what was measured on it."""
    feed, hold = choice.ports.parts
    outputs = [one for one in choice.ports.outputs if one not in choice.ports.inputs]
    measure = [one for one in outputs if one in choice.outputs or one in known.formulas]
    return compose_bench(tree, feed, hold, muscle, measure, name, known.points).text


def _suited(one: Ports, points: bool) -> Ports | None:
    """A bench for such recordings: of points at rest it has a direction, of others it has none; None: not suited."""
    if one.parts and points:
        branch = Variable(BRANCH, "1", "Direction of the branch")
        return replace(one, inputs={**one.inputs, BRANCH: branch})
    has_branch = BRANCH in one.inputs
    return one if has_branch == points else None


def _all_imposed(one: Ports) -> bool:
    """Whether a row says what acts on the muscle: a table tells no mass, spring or lever."""
    meanings = [meaning_of(variable) for variable in one.inputs.values()]
    return any(meaning is not None and meaning.kind in MECHANICAL for meaning in meanings)


def _named(
    place: Path, model: str, known: ReadRecordings, describe: Callable[[str], Interface]
) -> Bench:
    """The bench of a name; a file is copied."""
    copied = copy_files([Path(model)], place)[0] if is_file(model) else None
    interface = describe(str(place / copied) if copied else model)
    fixed = Ports(interface.model, interface.inputs, interface.outputs)
    choice = choose([fixed], known.columns, known.asked, known.formulas, len(known.sources))
    return Bench(choice, copied or interface.model, interface, "")


def class_name(folder: Path) -> str:
    """A name for the class, made from that of the folder: ``my-rig`` is ``MyRig``."""
    words = re.findall(r"[A-Za-z][A-Za-z0-9]*", folder.resolve().name)
    name = "".join(word[0].upper() + word[1:] for word in words)[:40]
    return name if name.endswith(_SUFFIX) else f"{name}{_SUFFIX}"
