"""Data sets: read and checked against a model, or drafted from the files of a laboratory."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from pam_cosim.catalogue import known_domain
from pam_cosim.compiler import read_library
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting import DraftRequests, NewDataSet, draft
from pam_cosim.errors import InputError
from pam_cosim.fitting import starts_are_open, with_starts
from pam_cosim.measurement import DataSet, Moment, Overrides, overrides_of, read_data_set
from pam_cosim.model.domain import Domain
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import is_fmu, is_ratio, parameter_of, sources_of
from pam_cosim.model.settings import Setting, resolve, value_of
from pam_cosim.simulation.models import Paths, as_paths, describe, opened
from pam_cosim.study.fitted_model import (
    judged_data,
    with_own_values,
)
from pam_cosim.study.library import benches
from pam_cosim.study.mapped_model import mapped_model
from pam_cosim.study.read_limits import check_inputs, inputs_beyond
from pam_cosim.wording import did_you_mean, shown


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
        roles: "fit" or "holdout" by run, where it shall be another one than the data set says. A pattern such as
            "test*" in the place of a run, here, for ``cuts`` and for ``starts``: all runs that have no own value.
        cuts: the first and the last time of a run, by run, instead of ``from`` and ``to`` of the data set: [s] of the
            file's own clock or texts with a unit; None: as it was recorded. Where it begins elsewhere then, its start
            is chosen anew.
        starts: "rest", "steady", "measured" or "estimated" by run, likewise, where it shall begin otherwise than the
            data set says.

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
                "what was judged keeps its ends and starts; cut the data set that it is of", folder
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
    data = replace(data, domain=_domain(data.model, described(data.model), files))
    return for_model(data, model, files)


def check_is_read(data: object) -> None:
    """Raises InputError where a function is given something else than a data set, such as its folder."""
    check_kind(data, DataSet, "a data set is needed", "read it by pam.read(FOLDER)")


def check_kind(given: object, kinds: type | tuple[type, ...], needed: str, hint: str) -> None:
    """Raises InputError where a function is given something else than it takes, such as the name of a file."""
    if not isinstance(given, kinds):
        of = shown(given) if isinstance(given, str | Path) else f"a {type(given).__name__}"
        raise InputError(f"{needed}, not {of}: {hint}")


def _check_there(folder: Path | str) -> None:
    """Whatever else keeps a data set from being read is told by whoever reads it."""
    try:
        os.lstat(folder)
    except FileNotFoundError:
        raise InputError(
            "does not exist; a data set is a folder with experiment.toml and CSV files", folder
        ) from None
    except (OSError, ValueError):
        pass


def for_model(data: DataSet, model: str | None, files: Paths) -> DataSet:
    """The data set for a model: values that a Modelica model of another name states stand before starts of a fit."""
    check_is_read(data)
    if model is None or model in (data.bench, data.unmapped) or is_fmu(model):
        return data
    has_starts = any(free.start is not None for free in data.fit.values())
    return with_own_values(data, model, as_paths(files)) if data.bench and has_starts else data


def _domain(model: str, interface: Interface, files: Paths) -> Domain:
    """The words of the model's field; an FMU says what class it was made from."""
    sources = sources_of(as_paths(files), model)
    return known_domain(interface.model if is_fmu(model) else model, sources)


def new(
    folder: Path | str,
    recordings: Paths,
    *,
    title: str | None = None,
    model: str | None = None,
    muscle: str | None = None,
    columns: Mapping[str, str] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    recording: Mapping[str, object] | None = None,
    roles: Mapping[str, str] | None = None,
    files: Paths = (),
) -> NewDataSet:
    """Writes a data set from recordings as labs have them, and says what was recognised and what was guessed.

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
        columns: names of columns, or formulas, by inputs, outputs or "time".
        parameters: what is known of all runs, with units.
        recording: keys of ``[recording]`` of ``experiment.toml``, as far as files do not show them.
        roles: "fit" or "holdout", by the names of recordings without their endings, or by patterns.
        files: further Modelica files.

    Raises:
        InputError: whatever cannot be used, with file, line and column; nothing is written then.
    """
    stated = {name: str(value) for name, value in (parameters or {}).items()}
    wishes = DraftRequests(title, model, columns, stated, recording, muscle, roles)
    paths = [Path(one) for one in recordings]
    described = described_with(files)
    made = draft(
        Path(folder),
        paths,
        wishes,
        read_library(files=as_paths(files)),
        described,
        as_paths(files),
    )
    written = _read(made.folder, described, files, Overrides())
    beyond = inputs_beyond(written, described(written.model))
    begun = data_with_starts(written, written.model, files=files)
    return replace(made, data=written, starts=begun.starts, to_check=(*beyond, *made.to_check))


def few_rows(data: DataSet) -> bool:
    """Whether simulating all runs once or twice takes less time than a compiler does."""
    return sum(len(run.time) for run in data.runs) <= CRITERIA.run.rows_without_compiler


def data_with_starts(
    data: DataSet,
    model: str,
    values: Mapping[str, float] | None = None,
    files: Paths = (),
    timeout: float | None = None,
) -> DataSet:
    """The data set where every run says how it begins.

    Args:
        data: the measurement.
        model: what it is held against.
        values: by name [SI].
        files: further Modelica files.
        timeout: as in ``simulate``.
    """
    if not starts_are_open(data):
        return data
    with opened(model, files, timeout=timeout, brief=few_rows(data)) as simulator:
        return with_starts(simulator, data, values)


def overriding(values: Mapping[str, float], data: DataSet) -> dict[str, float]:
    """Values of all runs [SI], also of those runs of which the data set states another one."""
    own = {
        f"{name}@{run.name}": v
        for run in data.runs
        for name, v in values.items()
        if name in run.parameters
    }
    return {**own, **values}


def values_of_runs(
    parameters: Mapping[str, Setting], data: DataSet, interface: Interface
) -> dict[str, float]:
    """Values by name [SI], of all runs or of one: "load.m", "load.m@run-01"."""
    values: dict[str, float] = {}
    for name, value in parameters.items():
        parameter, at, run = name.rpartition("@")
        if at and parameter in interface.settable:
            if run not in [r.name for r in data.runs]:
                known = [r.name for r in data.runs]
                raise InputError(
                    f"{data.title} has no run '{run}', of which '{name}' would be; {did_you_mean(run, known)}"
                )
            values[name] = resolve({parameter: value}, interface)[parameter]
        elif is_ratio(name) and parameter_of(name) in interface.settable:
            values[name] = value_of(value, Variable(name, "1"))
        else:
            values |= resolve({name: value}, interface)
    return values
