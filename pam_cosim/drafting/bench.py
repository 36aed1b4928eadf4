"""The bench of a new data set: the one that the user names, a ready one, or one that is put together from parts."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from pam_cosim.catalogue.ports import Ports, ports
from pam_cosim.catalogue.rig import put_together
from pam_cosim.compiler import ClassTree
from pam_cosim.drafting.choice import Choice, choose
from pam_cosim.drafting.folder import copy_files
from pam_cosim.drafting.wishes import Known, Wishes
from pam_cosim.errors import InputError
from pam_cosim.interface import Interface
from pam_cosim.names import is_file
from pam_cosim.wording import listed

_SUFFIX = "Rig"


@dataclass(frozen=True)
class Bench:
    """A bench and what feeds it; ``name`` is as ``experiment.toml`` has it, ``why`` empty where the user says so."""

    choice: Choice
    name: str
    interface: Interface
    why: str


def take_bench(
    place: Path, name: str, wishes: Wishes, known: Known, tree: ClassTree, describe: Callable[[str], Interface]
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
    candidates, runs = ports(tree), len(known.sources)
    rigs = {one.name: one for one in candidates if one.parts}
    if wishes.model is not None and wishes.model not in rigs:
        if wishes.muscle is not None:
            raise InputError(f"a muscle is named for a bench that is put together, and {wishes.model} is there already")
        return _named(place, wishes.model, known, describe)
    if wishes.muscle is not None:
        candidates = list(rigs.values())
    candidates = candidates if wishes.model is None else [rigs[wishes.model]]
    choice = choose(candidates, known.columns, known.asked, known.formulas, runs)
    fed = listed(f"{one} = {column.name}" for one, column in choice.fed.items())
    why = f"guessed: the bench, because it takes and shows what was recorded: {fed}"
    if choice.others:
        why += f". Others would do: {listed(choice.others)}"
    if not choice.ports.parts:
        return Bench(choice, choice.ports.name, describe(choice.ports.name), why)
    feed, hold = choice.ports.parts
    outputs = [one for one in choice.ports.outputs if one not in choice.ports.inputs]
    measure = [one for one in outputs if one in choice.outputs or one in known.formulas]
    text = put_together(tree, feed, hold, wishes.muscle, measure, name).text
    (place / f"{name}.mo").write_text(text, encoding="utf-8", newline="\n")
    made = f"{name}.mo was put together from {choice.ports.name}"
    why = made if wishes.model else f"{why}. {made}"
    return Bench(choice, f"{name}.mo", describe(str(place / f"{name}.mo")), why)


def _named(place: Path, model: str, known: Known, describe: Callable[[str], Interface]) -> Bench:
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
