"""Data sets: read and checked against a model, or drafted from the files of a laboratory."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from pam_cosim.catalogue import known_domain
from pam_cosim.compiler import read_library
from pam_cosim.drafting import DraftRequests, NewDataSet, draft
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.measurement import DataSet, Moment, Overrides, overrides_of, read_data_set
from pam_cosim.model.domain import Domain
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu, sources_of
from pam_cosim.model.settings import Setting
from pam_cosim.simulation.models import Paths, as_paths, describe
from pam_cosim.study.comparisons import compared
from pam_cosim.study.fitted_model import judged_data
from pam_cosim.study.library import benches
from pam_cosim.study.mapped_model import mapped_model
from pam_cosim.study.problems import data_with_starts, problem
from pam_cosim.study.read_limits import check_inputs, inputs_beyond

_LONGEST = 60.0  # [s] that the first run of a draft may take


def described_with(files: Paths) -> Callable[[str], Interface]:
    """Gives the interface of a model by its name, and builds each but once."""
    return cache(lambda name: describe(name, files))


def read(
    folder: Path | str,
    *,
    model: str | None = None,
    files: Paths = (),
    roles: Mapping[str, str] | None = None,
    cuts: Mapping[str, Sequence[Moment]] | None = None,
    starts: Mapping[str, str] | None = None,
) -> DataSet:
    """Reads a data set and checks it against its bench (or against ``model``).

    ```python
    data = pam.read("my-rig", cuts={"run-03": ("2.5 s", None)}, starts={"run-03": "estimated"})
    ```

    Args:
        folder: of the data set; or a saved diagnosis, fit or comparison (``.npz``): the data set as that judged it,
            without the samples that it set aside.
        model: default: the bench of the data set.
        files: further Modelica files.
        roles: "fit" or "holdout" by run, where it shall be another one than the data set states. A pattern such as
            "test*" in the place of a run, here, for ``cuts`` and for ``starts``: all runs that have no own value.
        cuts: the first and the last time of a run, by run, instead of ``from`` and ``to`` of the data set: [s] of the
            file's own clock or texts with a unit; None: as it was recorded. Where it begins elsewhere then, its start
            is chosen again.
        starts: "rest", "steady", "measured" or "estimated" by run, likewise, where it shall begin otherwise than the
            data set states.

    Raises:
        InputError: with file, line and column of what cannot be used; no such run, role or start; nothing is left;
            an input beyond what the model allows.
    """
    _check_there(folder)
    described = described_with(files)
    data = _read(Path(folder), described, files, overrides_of(cuts, starts), model)
    data = data.with_roles(roles or {})
    check_inputs(data, described(data.model))
    return data


def _read(
    folder: Path,
    described: Callable[[str], Interface],
    files: Paths,
    overrides: Overrides,
    model: str | None = None,
) -> DataSet:
    """As ``read``, whatever the inputs are, with the roles that are stated."""
    if folder.suffix.lower() == ".npz":
        if overrides != Overrides():
            raise InputError(
                "a saved product keeps its cuts and initial states; cut its data set instead",
                folder,
            )
        data = judged_data(folder)
        data = replace(data, model=model or data.model)
    else:
        data = read_data_set(
            folder,
            described,
            model=model,
            benches=lambda: benches(files),
            with_maps=lambda base, maps: mapped_model(base, described(base), maps, as_paths(files)),
            overrides=overrides,
        )
    return replace(data, domain=_domain(data.model, described(data.model), files))


def _check_there(folder: Path | str) -> None:
    """Other errors of the data set are reported when it is read."""
    try:
        os.lstat(folder)
    except FileNotFoundError:
        raise InputError(
            "does not exist; a data set is a folder with experiment.toml and CSV files", folder
        ) from None
    except (OSError, ValueError):
        pass


def _domain(model: str, interface: Interface, files: Paths) -> Domain:
    """The vocabulary of the model's field; an FMU states from which class it was made."""
    sources = sources_of(as_paths(files), model)
    return known_domain(interface.model if is_fmu(model) else model, sources)


def new(
    folder: Path | str,
    recordings: Paths,
    *,
    title: str | None = None,
    model: str | None = None,
    muscle: str | None = None,
    valve: str | None = None,
    columns: Mapping[str, str] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    recording: Mapping[str, object] | None = None,
    roles: Mapping[str, str] | None = None,
    files: Paths = (),
) -> NewDataSet:
    """Writes a data set from recordings of a laboratory, and reports what was recognised and what was guessed.

    ```python
    print(pam.new("my-rig", ["data/run-01.csv", "data/run-02.csv"], parameters={"load.m": "2.27 kg"}))
    ```

    The recordings are copied. Columns are recognised by names, units and what the numbers look like; the bench is the
    one that takes and shows most of them, put together from parts where there is none. Every guess is marked in
    ``experiment.toml``.

    Args:
        folder: of the new data set, missing or empty.
        recordings: files, one run each.
        title: default: the folder's name.
        model: the bench; a ``.mo`` or ``.fmu`` file is copied too.
        muscle: one of ``rig_parts``, by name; the bench is then put together.
        valve: what its data sheet states, as "0.8 mm2 at 250 mA" or "120 l/min at 300 mA from 40 mA"; of valves that
            differ "u_in=0.8 mm2 at 250 mA; u_out=1.2 mm2 at 250 mA".
        columns: names of columns, or formulas, by inputs, outputs or "time".
        parameters: what is known of all runs, with units.
        recording: keys of ``[recording]`` of ``experiment.toml``, as far as files do not show them.
        roles: "fit" or "holdout", by the names of recordings without their endings, or by patterns.
        files: further Modelica files.

    Raises:
        InputError: whatever cannot be used, with file, line and column; nothing is written then.
    """
    stated = {name: str(value) for name, value in (parameters or {}).items()}
    wishes = DraftRequests(title, model, columns, stated, recording, muscle, roles, valve)
    paths = [Path(file) for file in recordings]
    described = described_with(files)
    new_data_set = draft(
        Path(folder),
        paths,
        wishes,
        read_library(files=as_paths(files)),
        described,
        lambda data: _simulated(data, as_paths(files), described(data.model)),
        as_paths(files),
    )
    try:
        written = _read(new_data_set.folder, described, files, Overrides())
        beyond = inputs_beyond(written, described(written.model))
        begun = data_with_starts(problem(written, files=files))
    except (InputError, SimulationFailure):
        shutil.rmtree(new_data_set.folder)
        raise
    return replace(
        new_data_set, data=written, starts=begun.starts, to_check=(*beyond, *new_data_set.to_check)
    )


def _simulated(data: DataSet, files: Sequence[Path], interface: Interface) -> None:
    """Simulates the runs of a draft with what it states, unless their inputs are impossible, which is reported.

    Raises:
        SimulationFailure: a run does not reach its end.
    """
    if not inputs_beyond(data, interface):
        compared(problem(data, files=files), _LONGEST, with_conventions=False)
