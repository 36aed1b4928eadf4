"""The problem that a step of a study is about: a data set, a model, and the values that count."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from pam_cosim.catalogue import qualified
from pam_cosim.compiler import ClassTree, names, read_library, read_structure
from pam_cosim.errors import InputError
from pam_cosim.files import MOST_TEXT, read_file
from pam_cosim.fitting import with_starts
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import is_file, is_fmu, sources_of
from pam_cosim.model.settings import Setting
from pam_cosim.problems import ModelValues, Problem, corrections_in
from pam_cosim.problems import problem as _problem
from pam_cosim.problems.corrections import KEY
from pam_cosim.simulation.models import MOST_ROWS_UNCOMPILED, Paths, as_paths, describe, opened
from pam_cosim.starts import starts_are_open
from pam_cosim.wording import shown


def problem(
    data: DataSet,
    model: str | None = None,
    *,
    values: Mapping[str, Setting] | None = None,
    free: Sequence[str] | None = None,
    start: Mapping[str, Setting] | None = None,
    fitted: Mapping[str, Setting] | None = None,
    files: Paths = (),
    origin: str = "an earlier fit",
) -> Problem:
    """Resolves what is compared or fitted: every value of every run, with where it comes from.

    ```python
    print(pam.problem(data, values={"load.m": "6 kg"}, free=["valve.C_A"]))
    ```

    A later source counts before an earlier one: the default of the class, the model (``Better.mo``) or an earlier fit,
    the data set, the run, what a verdict corrected (as ``add`` writes it into ``Better.mo``), the caller.

    Args:
        data: the measurement.
        model: default: the bench of the data set.
        values: of parameters, of inputs that are held constant, and of initial states, by name: numbers [SI] or texts
            with a unit. "load.m@run-01" is of one run, "load.m/stated" a factor on what the data set states,
            "gas.p@run-01" an initial state. What is stated here is not fitted.
        free: names of the parameters that are fitted, instead of those of the data set: any that has bounds, or that
            the data set states. The others are held at their initial guesses.
        start: initial guesses by name; "gas.p@run-01" is where the estimate of an initial state begins.
        fitted: values of an earlier fit, by name; what the data set or a run states counts before them.
        files: further Modelica files.
        origin: of ``fitted``, as messages name it.

    Raises:
        InputError: an unknown name or run, with the nearest one that exists; a value that cannot be used; a parameter
            that cannot be fitted.
    """
    check_is_read(data)
    for argument, stated in (("values", values), ("start", start), ("fitted", fitted)):
        check_kind(
            stated or {},
            Mapping,
            f"{argument} is a mapping of values by name",
            "as {'load.m': '6 kg'}",
        )
    name, paths = data.model_for(model), as_paths(files)
    interface = describe(name, paths)
    model_values = _model_values(data, name, paths)
    if fitted:
        model_values = replace(model_values, fitted=fitted, origin=origin)
    return _problem(
        data,
        name,
        interface,
        paths,
        model_values=model_values,
        values=values,
        free=free,
        guesses=start,
    )


def as_problem(
    data: DataSet | Problem, model: str | None = None, files: Paths = (), **stated: object
) -> Problem:
    """The problem itself, or that of a data set with the stated options, as ``problem`` takes it.

    Raises:
        InputError: as ``problem``; a problem together with further options.
    """
    if not isinstance(data, Problem):
        return problem(data, model, files=files, **stated)  # type: ignore[arg-type]
    if model is not None or as_paths(files) or any(value for value in stated.values()):
        raise InputError(
            "a problem has its model, files, values and free parameters: state them in pam.problem"
        )
    return data


def check_is_read(data: object) -> None:
    """Raises InputError where a function is given something else than a data set, such as its folder."""
    check_kind(data, DataSet, "a data set is needed", "read it by pam.read(FOLDER)")


def check_kind(
    argument: object, kinds: type | tuple[type, ...], requirement: str, hint: str
) -> None:
    """Raises InputError where a function is given something else than it takes, such as the name of a file."""
    if not isinstance(argument, kinds):
        of = shown(argument) if isinstance(argument, str | Path) else f"a {type(argument).__name__}"
        raise InputError(f"{requirement}, not {of}: {hint}")


def few_rows(data: DataSet) -> bool:
    """Whether simulating all runs once or twice takes less time than a compiler does."""
    return sum(len(run.time) for run in data.runs) <= MOST_ROWS_UNCOMPILED


def data_with_starts(problem: Problem, timeout: float | None = None) -> DataSet:
    """The data set of a problem where every run states how it begins.

    Args:
        problem: what is compared or fitted.
        timeout: as in ``simulate``.
    """
    data = problem.data
    if not starts_are_open(data):
        return data
    with opened(problem.model, problem.files, timeout=timeout, brief=few_rows(data)) as simulator:
        return with_starts(simulator, data, problem.settings)


def _model_values(data: DataSet, name: str, files: Sequence[Path]) -> ModelValues:
    """Values that a model states: those of its own text, where it is another than the data set's, and corrections."""
    if is_fmu(name):
        return ModelValues()
    sources = sources_of(files, name, *[data.bench] * bool(data.bench))
    requested = data.unmapped if data.unmapped and name == data.model else name
    other = data.bench and requested != data.bench
    has_starts = any(free.start is not None for free in data.fit.values())
    is_open = other and (has_starts or is_file(name))
    if not (is_open or any(map(_keeps_corrections, sources))):
        return ModelValues()
    tree = read_library(files=sources)
    lineage, bench = _lineage(tree, name, sources), _lineage(tree, data.bench, sources)
    stated = (
        {n for ancestor in lineage if ancestor not in bench for n in _stated(tree, ancestor)}
        if other
        else ()
    )
    label = Path(name).name if is_file(name) else names.last(name)
    return ModelValues(label, frozenset(stated), corrections=corrections_in(tree, lineage))


def _keeps_corrections(source: Path) -> bool:
    files = source.rglob("*.mo") if source.is_dir() else [source]
    return any(f"{KEY}={{".encode() in read_file(file, MOST_TEXT) for file in files)


def _lineage(tree: ClassTree, model: str, files: Sequence[Path]) -> list[str]:
    """A class and all that it inherits from, by full names; nothing for an FMU or without a model."""
    if not model or is_fmu(model):
        return []
    name = read_structure(qualified(tree, model), files=files).model
    return [name, *tree.bases(name)]


def _stated(tree: ClassTree, name: str) -> set[str]:
    """Full names of all that a class itself gives a value."""
    info = tree.classes[name]
    inherited = {name for base in info.extends for name in base.modifications}
    modified = {f"{c.name}.{name}" for c in info.components for name in c.modifications}
    return inherited | modified | {c.name for c in info.components if c.value}
