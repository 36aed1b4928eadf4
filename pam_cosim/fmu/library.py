"""Modelica models to FMUs, each built once and kept in the cache."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from pam_cosim.cache import cached, digest
from pam_cosim.catalogue import full_name
from pam_cosim.compiler import (
    Ode,
    compile_model,
    few_collections,
    flat_hash,
    smooth_parameters,
    with_sensitivities,
)
from pam_cosim.errors import InputError, ModelChange
from pam_cosim.files import check_regular
from pam_cosim.fmu.build import (
    cached_description,
    cached_fmu,
    cached_lean_model,
    cached_taped_model,
    cached_whole_taped_model,
)
from pam_cosim.fmu.odes import cached_ode
from pam_cosim.model.references import START_VALUES, is_fmu, is_modelica


def build_model(
    model: str,
    files: Sequence[Path] = (),
    *,
    platforms: Sequence[str] = ("native",),
    sensitivities: Sequence[str] = (),
    where_smooth: bool = False,
    fmi: str = "2.0",
    brief: bool = False,
    documented: bool = False,
) -> Path:
    """The FMU of a model.

    Args:
        model: a bench's name, a Modelica class (of the library also without its name, ``Examples.ButylIsotonic``), or
            the path of a ``.mo`` file; an ``.fmu`` file is itself.
        files: the user's ``.mo`` files that the model may use.
        platforms: as in ``build_fmu``.
        fmi: as in ``build_fmu``.
        sensitivities: parameters; the FMU gets the derivative of every output with respect to each of them as the
            output ``sensitivity.<output>.<parameter>``, integrated with the states; ``names.START_VALUES`` among them
            stands for the start values of all states.
        where_smooth: leave out those that the model does not have or that are lengths of delays.
        brief: for a few runs on this machine, made without a compiler, unpacked: a folder; see
            ``cached_whole_taped_model``.
        documented: with the date, documentation and pictures, for other people.

    Raises:
        ModelError: the model cannot be compiled.
        InputError: there is no such FMU or parameter, or the cache cannot be written.
    """
    if is_fmu(model) and sensitivities:
        raise InputError("sensitivities can be built into a Modelica model only", model)
    if is_fmu(model):
        return _as_it_is(model)
    key, make = _recipe(full_name(model, files), files, sensitivities, where_smooth)
    if brief:
        return cached_whole_taped_model(key, make)
    model_files = [*files, Path(model)] if is_modelica(model) else files
    return cached_fmu(
        key, make, platforms=platforms, fmi=fmi, documented=model_files if documented else None
    )


def description_of(model: str, files: Sequence[Path] = ()) -> Path:
    """A folder with the model description that the FMU of a model has, made without a compiler; an FMU is itself.

    Raises:
        ModelError: the model cannot be compiled.
        InputError: there is no such FMU, or the cache cannot be written.
    """
    if is_fmu(model):
        return _as_it_is(model)
    return cached_description(*_recipe(full_name(model, files), files, (), where_smooth=False))


def _as_it_is(fmu: str) -> Path:
    check_regular(Path(fmu))
    return Path(fmu)


def _recipe(
    model: str,
    files: Sequence[Path],
    sensitivities: Sequence[str],
    where_smooth: bool,
    library: str = "",
) -> tuple[str, Callable[[], Ode]]:
    """What determines a model, and how it is compiled."""
    key = flat_hash(model, files=files, library=library)

    def compiled() -> Ode:
        ode = compile_model(model, files=files)
        if flat_hash(model, files=files) != key:
            raise ModelChange("a Modelica file changed since this began: begin again", model)
        return ode

    def make() -> Ode:
        ode = cached_ode(key, compiled)
        differentiable = smooth_parameters(ode) if where_smooth else sensitivities
        chosen = [name for name in sensitivities if name in differentiable and name != START_VALUES]
        starts = (
            [s.name for s in ode.states if s.name not in chosen]
            if START_VALUES in sensitivities
            else []
        )
        return with_sensitivities(ode, [*chosen, *starts])

    return digest(key, str(where_smooth), *sensitivities), make


def source_ode(model: str, text: str, files: Sequence[Path] = ()) -> Ode:
    """The equations of a model whose Modelica source is at hand as text; compiled once and kept in the cache.

    Args:
        model: name of the class in ``text``.
        text: Modelica source.
        files: further ``.mo`` files that it may use.

    Raises:
        ModelError: the model cannot be compiled.
    """
    all_files = [*files, _source(text)]
    return cached_ode(
        flat_hash(model, files=all_files), lambda: compile_model(model, files=all_files)
    )


def _source(text: str) -> Path:
    """A file that holds a text."""
    return cached("sources", digest(text), ".mo", text.encode)


def build_source(
    model: str,
    text: str,
    files: Sequence[Path] = (),
    *,
    sensitivities: Sequence[str] = (),
    library: str = "",
    lean: bool = False,
    brief: bool = False,
) -> Path:
    """The FMU of a model whose Modelica source is at hand as text.

    Args:
        model: name of the class in ``text``.
        text: Modelica source.
        files: further ``.mo`` files that it may use.
        sensitivities: as in ``build_model``, where the solution is smooth.
        library: ``compiler.library_hash()``, where it was computed before.
        lean: only what fits need, unpacked: a folder; see ``cached_lean_model``.
        brief: for a few runs, without a compiler: a folder too; see ``cached_taped_model``.

    Raises:
        ModelError: the model cannot be compiled.
    """
    key, make = _recipe(
        model, [*files, _source(text)], sensitivities, where_smooth=True, library=library
    )
    with few_collections():
        if brief:
            return cached_taped_model(key, make) if lean else cached_whole_taped_model(key, make)
        return cached_lean_model(key, make) if lean else cached_fmu(key, make)
