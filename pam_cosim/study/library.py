"""What the library offers: benches, effects and parts, and benches that are composed of them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pam_cosim.catalogue import BenchPart, EffectClass, compose_bench, effect_classes
from pam_cosim.catalogue import benches as _benches
from pam_cosim.catalogue import rig_parts as _rig_parts
from pam_cosim.catalogue.effect_sheet import EffectSheet, effect_sheet
from pam_cosim.compiler import names, read_library, read_structure
from pam_cosim.compiler.names import last
from pam_cosim.errors import InputError
from pam_cosim.files import check_model_file, write_text
from pam_cosim.simulation.models import Paths, as_paths
from pam_cosim.wording import did_you_mean


def benches(files: Paths = ()) -> list[str]:
    """Names of the benches of the library, and of those among ``files``."""
    return [last(bench) for bench in _benches(read_library(files=as_paths(files)))]


def effects(files: Paths = ()) -> list[EffectClass]:
    """The catalogue: every effect of the library and of ``files``."""
    return list(effect_classes(read_library(files=as_paths(files))))


def effect_sheets(name: str | None = None, files: Paths = ()) -> list[EffectSheet]:
    """Effects in full: the one of a name, those of a family, or all.

    Raises:
        InputError: there is neither an effect nor a family of that name.
    """
    sources = as_paths(files)
    tree = read_library(files=sources)
    classes = effect_classes(tree)
    matching_effects = [e for e in classes if name in (None, e.name, e.qualified_name, e.family)]
    if not matching_effects:
        names = dict.fromkeys(word for e in classes for word in (e.name, e.family))
        hint = did_you_mean(str(name), list(names))
        raise InputError(f"there is no effect and no family '{name}'; {hint}")
    structures = {last(bench): read_structure(bench, files=sources) for bench in _benches(tree)}
    return [effect_sheet(tree, effect, structures) for effect in matching_effects]


def rig_parts(files: Paths = ()) -> list[BenchPart]:
    """What a bench can be put together from: every part of the library and of ``files``."""
    return list(_rig_parts(read_library(files=as_paths(files))))


def bench(
    pneumatics: str,
    mechanics: str,
    muscle: str | None = None,
    measure: str | Sequence[str] | None = None,
    output: Path | str | None = None,
    *,
    static: bool = False,
    files: Paths = (),
) -> str:
    """The Modelica text of a rig put together from parts; written to ``output`` if given.

    ```python
    pam.bench("regulator", "spring", measure="p, x", output="MyRig.mo")
    run = pam.simulate("MyRig.mo", {"p_set": "300 kPa", "spring.k": "3 N/mm"})
    ```

    Args:
        pneumatics: what feeds the muscle, by its name in ``rig_parts`` or the full name of its class.
        mechanics: what holds its load end, likewise; it determines the number of muscles.
        muscle: likewise; default: the usual one.
        measure: the signals that are read: names, or one text with commas. With several muscles "x" is that of each
            and "x_1" that of the first. Default: what is usual with these parts.
        output: a file that ends in ``.mo``.
        static: for points at rest; an input ``branch`` is then the direction in which they were reached.
        files: further Modelica files with parts of one's own.

    Raises:
        InputError: an unknown part or signal, a signal that is imposed, or parts that do not fit together.
        ModelError: a part is not what its interface requires.
    """
    if output:
        check_model_file(Path(output))
    name, tree = Path(output).stem if output else None, read_library(files=as_paths(files))
    if name in names.PREDEFINED:
        raise InputError(f"there is a class {name} already: choose another name")
    rig = compose_bench(tree, pneumatics, mechanics, muscle, measure, name, static)
    if output:
        write_text(Path(output), rig.text)
    return rig.text
