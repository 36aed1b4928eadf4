"""A model with effects and fitted values, taken from what a study produced, as Modelica that holds both."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from pydantic import BaseModel, FiniteFloat, ValidationError

from pam_cosim.catalogue import Composition, compose, qualified
from pam_cosim.comparison import Comparison
from pam_cosim.compiler import ClassTree, names, read_library, read_structure
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import MOST_TEXT, read_file, read_json
from pam_cosim.fitting import Fit, parameters_in, read_parameters, units_in
from pam_cosim.measurement import DataSet
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import is_fmu, is_modelica, is_ratio, sources_of
from pam_cosim.model.settings import settable, value_of
from pam_cosim.study.products import load
from pam_cosim.units import same_unit
from pam_cosim.wording import shown


@dataclass(frozen=True)
class FittedModel:
    """A model, the effects that were added to it, and the values of its parameters.

    Attributes:
        model: the base model: a bench, a Modelica class or a ``.mo`` file.
        effects: that were added, in order.
        values: by name [SI]; also those of one run alone ("load.m@run-01") and ratios to what the data set states.
        constants: what else all runs were simulated with [SI], parameters and inputs; see ``DataSet.constants``.
        units: of values, those that a file names.
    """

    model: str
    effects: tuple[str, ...]
    values: Mapping[str, float]
    constants: Mapping[str, float] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)

    @property
    def of_the_model(self) -> dict[str, float]:
        """The values that a model can hold: those of its own parameters."""
        return {name: value for name, value in self.values.items() if not _of_the_data(name)}

    def stated(self, parameters: Collection[str]) -> dict[str, float]:
        """What the model's text states [SI]: constants that are among the base model's parameters, and its values."""
        return {n: v for n, v in self.constants.items() if n in parameters} | self.of_the_model

    @property
    def of_the_data(self) -> dict[str, float]:
        """The others: of one run alone, and ratios to what the data set states of a parameter."""
        return {name: value for name, value in self.values.items() if _of_the_data(name)}


def _of_the_data(name: str) -> bool:
    return "@" in name or is_ratio(name)


class _Final(BaseModel):
    """What a JSON document says of the model that its parameters are of."""

    model: str = ""
    effects: tuple[str, ...] = ()
    constants: dict[str, FiniteFloat] = {}


def fitted_model(product: Diagnosis | Fit | Comparison) -> FittedModel:
    """What a diagnosis or a fit came to, or what was compared."""
    if isinstance(product, Diagnosis):
        effects = tuple(c.effect for c in product.path)
        return FittedModel(product.model, effects, product.final.values, product.data.constants)
    if isinstance(product, Fit):
        return FittedModel(product.model, (), product.values, product.comparison.data.constants)
    return FittedModel(product.model, (), product.parameters)


def with_own_values(data: DataSet, model: str, files: Sequence[Path]) -> DataSet:
    """The data set for another model than its own: values that this one states stand before where a fit would start.

    Args:
        data: the measurement.
        model: the other model.
        files: further Modelica files.
    """
    sources = sources_of(files, data.bench, model)
    tree = read_library(files=sources)
    stated = {
        n
        for one in _lineage(tree, model, sources) - _lineage(tree, data.bench, sources)
        for n in _stated(tree, one)
    }
    fit = {n: replace(f, start=None) if f.parameter in stated else f for n, f in data.fit.items()}
    return replace(data, fit=fit)


def _lineage(tree: ClassTree, model: str, files: Sequence[Path]) -> set[str]:
    """A class and all that it inherits from, by full names; nothing for an FMU."""
    if is_fmu(model):
        return set()
    name = read_structure(qualified(tree, model), files=files).model
    return {name, *tree.bases(name)}


def _stated(tree: ClassTree, name: str) -> set[str]:
    """Full names of all that a class itself gives a value."""
    info = tree.classes[name]
    inherited = {name for base in info.extends for name in base.modifications}
    own = {f"{c.name}.{name}" for c in info.components for name in c.modifications}
    return inherited | own | {c.name for c in info.components if c.value}


def judged_data(path: Path) -> DataSet:
    """The data set of a saved product, without the samples that were set aside.

    Raises:
        InputError: no such file, or nothing that was compared with a measurement.
    """
    product = _judgement(path)
    if isinstance(product, Fit):
        return product.comparison.data
    return product.data


def _judgement(path: Path) -> Diagnosis | Fit | Comparison:
    product = load(path)
    if not isinstance(product, Diagnosis | Fit | Comparison):
        raise InputError(f"a {type(product).__name__} was not compared with a measurement", path)
    return product


def read_fitted_model(path: Path) -> FittedModel:
    """The model of a saved diagnosis, fit or comparison, or of the JSON or the parameters that a command wrote.

    Raises:
        InputError: no such file, or nothing with parameters.
    """
    suffix = path.suffix.lower()
    if suffix == ".npz":
        return fitted_model(_judgement(path))
    if suffix == ".ssv":
        return FittedModel("", (), read_parameters(path))
    content = read_json(path)
    values = parameters_in(content, path)
    try:
        found = _Final.model_validate(content.get("final", content))
    except ValidationError as error:
        wrong = error.errors()[0]
        raise InputError(f"{'.'.join(map(str, wrong['loc']))}: {wrong['msg']}", path) from None
    return FittedModel(found.model, found.effects, values, found.constants, units_in(content))


def _check_unit(unit: str, variable: Variable) -> None:
    """Raises InputError where a value is stated in another unit than the model's: it is read as it is."""
    if not same_unit(unit, variable.unit):
        raise InputError(
            f"{variable.name} is stated in {shown(unit)}; values are read in the model's unit, "
            f"{shown(variable.unit)}"
        )


def check_fitted(fitted: FittedModel, interface: Interface, file: Path) -> None:
    """Looks at the values that a file holds, before they are used.

    Args:
        fitted: what was read.
        interface: of the model that gets the values.
        file: that they were read from.

    Raises:
        InputError: there is no such parameter, a value beyond its range, or in another unit than the model's.
    """
    for name, value in fitted.values.items():
        parameter = name.partition("@")[0]
        if is_ratio(parameter):
            continue
        try:
            known = settable(parameter, interface)
            _check_unit(fitted.units.get(name, known.unit), known)
            value_of(value, known)
        except InputError as problem:
            raise InputError(problem.message, file) from None


def compose_fitted(
    tree: ClassTree,
    fitted: FittedModel,
    name: str | None,
    parameters: Collection[str],
    files: Sequence[Path],
    beside: str = "",
) -> Composition:
    """The Modelica class of a model with effects and values; its text stands by itself.

    Args:
        tree: the library with the user's files.
        fitted: the model.
        name: of the class; None: made from the names.
        parameters: names of all parameters of the base model.
        files: the user's files.
        beside: text of classes that it is made of, which its text then holds.

    Raises:
        InputError: an effect finds no place; a value is of none of the parameters; there is a class of that name.
    """
    values = fitted.stated(parameters)
    made = compose(tree, fitted.model, fitted.effects, name, files=files, values=values)
    if made is None:
        raise InputError(f"{fitted.model} has no place for {', '.join(fitted.effects)}")
    known = {*parameters, *(n for names in made.parameters.values() for n in names)}
    stray = next((n for n in values if n not in known), None)
    if stray is not None:
        raise InputError(f"{made.name} has no parameter '{stray}', of which there is a value")
    if made.name in tree.classes or made.name in names.PREDEFINED:
        raise InputError(f"there is a class {made.name} already: choose another name")
    if beside:
        made = replace(made, text=f"{beside.rstrip()}\n\n{made.text}")
    return replace(made, text=with_base(made, fitted.model))


def with_base(made: Composition, model: str) -> str:
    """The text of a model after that of the file whose model it extends; classes of packages are found by name."""
    if not is_modelica(model) or names.parent(made.base):
        return made.text
    return f"{read_file(Path(model), MOST_TEXT).decode('utf-8-sig').rstrip()}\n\n{made.text}"
