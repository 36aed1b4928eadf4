"""The bench of a new data set: the one that the user names, a ready one, or one that is put together from parts."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from pam_cosim.catalogue.bench_parts import rig_parts
from pam_cosim.catalogue.composed_bench import compose_bench
from pam_cosim.catalogue.ports import Ports, ports
from pam_cosim.compiler import ClassTree
from pam_cosim.drafting.bench_choice import MECHANICAL, BenchChoice, choose, meaning_of
from pam_cosim.drafting.file_names import Muscle, muscle_in
from pam_cosim.drafting.folder import copy_files
from pam_cosim.drafting.requests import DraftRequests, ReadRecordings
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import BRANCH, is_file
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
    candidates, runs = [one for one in map(_at_rest(known), ports(tree)) if one is not None], len(known.sources)
    rigs = {one.name: one for one in candidates if one.parts}
    if wishes.model is not None and wishes.model not in rigs:
        if wishes.muscle is not None:
            raise InputError(f"a muscle is named for a bench that is put together, and {wishes.model} is there already")
        return _named(place, wishes.model, known, describe)
    muscle = wishes.muscle
    said = [" ".join([source.file.stem, *source.labels]) for source in known.sources]
    told = muscle_in(said, _muscles(tree)) if muscle is None and wishes.model is None else None
    if told is not None:
        muscle = told.name
    if muscle is not None:
        candidates = list(rigs.values())
    if known.points and wishes.model is None:
        candidates = [one for one in candidates if _all_imposed(one)]
    candidates = candidates if wishes.model is None else [rigs[wishes.model]]
    every = dict.fromkeys([*known.stated, *(name for own in known.own for name in own)])
    stated = [name for name in every if "." not in name]
    choice = choose(candidates, known.columns, known.asked, known.formulas, runs, stated)
    fed = listed(f"{one} = {column.name}" for one, column in choice.fed.items())
    why = f"guessed: the bench, because it takes and shows what was recorded: {fed}"
    if choice.others:
        why += f". Others would do: {listed(choice.others)}"
    if not choice.ports.parts:
        return Bench(choice, choice.ports.name, describe(choice.ports.name), why, None, True)
    feed, hold = choice.ports.parts
    outputs = [one for one in choice.ports.outputs if one not in choice.ports.inputs]
    measure = [one for one in outputs if one in choice.outputs or one in known.formulas]
    text = compose_bench(tree, feed, hold, muscle, measure, name, known.points).text
    (place / f"{name}.mo").write_text(text, encoding="utf-8", newline="\n")
    made = f"{name}.mo was put together from {choice.ports.name}"
    if told is not None:
        made += f", with the muscle {told.name}, of which the files or their names tell"
    why = made if wishes.model else f"{why}. {made}"
    return Bench(choice, f"{name}.mo", describe(str(place / f"{name}.mo")), why, told, muscle is None)


def _at_rest(known: ReadRecordings) -> Callable[[Ports], Ports | None]:
    """What a bench is to such recordings: those of points at rest have a direction, and no others; None: not one."""

    def of(one: Ports) -> Ports | None:
        if one.parts and known.points:
            return replace(one, inputs={**one.inputs, BRANCH: Variable(BRANCH, "1", "Direction of the branch")})
        return one if (BRANCH in one.inputs) == known.points else None

    return of


def _all_imposed(one: Ports) -> bool:
    """Whether a row says what acts on the muscle: a table tells no mass, spring or lever."""
    meanings = [meaning_of(variable) for variable in one.inputs.values()]
    return any(meaning is not None and meaning.kind in MECHANICAL for meaning in meanings)


def _muscles(tree: ClassTree) -> list[str]:
    return [part.name for part in rig_parts(tree) if part.role == "muscle"]


def _named(place: Path, model: str, known: ReadRecordings, describe: Callable[[str], Interface]) -> Bench:
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
