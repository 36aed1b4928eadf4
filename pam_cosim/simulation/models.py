"""A model by its name as an FMU, and what it shows. Loads neither measurements nor pictures."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from pam_cosim.counts import checked_time
from pam_cosim.files import check_regular, check_writable, make_folder, write_bytes
from pam_cosim.fmu.built_here import is_built_here
from pam_cosim.fmu.read import read_interface
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu, model_name
from pam_cosim.simulation import IsolatedSimulator, Simulator

# fitted or compared rows, up to which compiling takes longer; measured: docs/results.md
MOST_ROWS_UNCOMPILED = 10_000

Paths = Sequence[Path | str]


def describe(model: str, files: Paths = ()) -> Interface:
    """Inputs, outputs and parameters of a model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.

    Raises:
        InputError: there is no such model, or it cannot be compiled.
    """
    model = model_name(model)
    if is_fmu(model):
        return read_interface(_built(model, ()))
    from pam_cosim.fmu.library import description_of

    return read_interface(description_of(model, as_paths(files)))


def build(
    model: str,
    output: Path | str | None = None,
    *,
    files: Paths = (),
    platforms: Sequence[str] = ("native",),
    fmi: str = "2.0",
    sensitivities: Sequence[str] = (),
) -> Path:
    """Builds an FMU, or finds it in the cache; with ``output`` it is put there.

    ``platforms`` names those that the FMU shall run on: "native", "all", or names such as "x86_64-windows".
    ``fmi`` is the version of the interface, "2.0" or "3.0". For each parameter in ``sensitivities`` the derivatives
    of the outputs with respect to it are outputs too, ``sensitivity.<output>.<parameter>``.
    """
    if output is not None:
        check_writable(Path(output), new_folder=True)
    model = model_name(model)
    fmu = _built(
        model,
        as_paths(files),
        platforms=platforms,
        fmi=fmi,
        sensitivities=sensitivities,
        documented=True,
    )
    if is_fmu(model):  # what is no FMU is no better under another name
        read_interface(fmu)
    if output is None:
        return fmu
    target = Path(output)
    make_folder(target.parent)
    write_bytes(target, fmu.read_bytes())
    return target


def opened(
    model: str,
    files: Paths = (),
    free: Iterable[str] = (),
    timeout: float | None = None,
    *,
    brief: bool = False,
) -> Simulator | IsolatedSimulator:
    """A model ready to run; an FMU of another tool runs in a process of its own, which it may crash.

    An FMU that this program built on this machine is run as a Modelica model is.

    A Modelica model returns its sensitivities to the ``free`` parameters. ``timeout`` [s]: a run of a Modelica model
    ends after so much processor time (None: ``LONGEST_RUN``); an FMU that makes no progress for so long is ended (None:
    the default of ``IsolatedSimulator``). ``brief``: a Modelica model is for a few runs, and made without a compiler.
    """
    model = model_name(model)
    if is_fmu(model):
        file = build(model, files=files)
        return (
            limited(Simulator(file), timeout)
            if is_built_here(file)
            else IsolatedSimulator(file, timeout)
        )
    fmu = _built(model, as_paths(files), sensitivities=tuple(free), where_smooth=True, brief=brief)
    return limited(Simulator(fmu), timeout)


def _built(model: str, files: Sequence[Path], **options: Any) -> Path:
    """As ``build_model``, which is loaded for a Modelica model alone."""
    if is_fmu(model) and not options.get("sensitivities"):
        check_regular(Path(model))
        return Path(model)
    from pam_cosim.fmu.library import build_model

    return build_model(model, files, **options)


def limited(simulator: Simulator, timeout: float | None) -> Simulator:
    """The same, its runs with another limit of processor time [s]; None: as it is.

    Raises:
        InputError: no such limit.
    """
    if timeout is not None and simulator.limit is not None:
        simulator.limit = checked_time(timeout), 0.0
    return simulator


def as_paths(files: Paths) -> list[Path]:
    """Names of files as paths."""
    return [Path(file) for file in files]
