"""A model with effects and fitted values, taken from what a study produced, as Modelica that holds both."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from shlex import quote

from pydantic import BaseModel, FiniteFloat, ValidationError

from pam_cosim.catalogue import Composition, compose
from pam_cosim.comparison import Comparison
from pam_cosim.compiler import ClassTree, names
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import MOST_TEXT, read_file, read_json
from pam_cosim.fitting import Fit, parameters_in, read_parameters, units_in
from pam_cosim.measurement import DataSet
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import is_modelica, is_ratio, parameter_of
from pam_cosim.model.settings import settable, value_of
from pam_cosim.problems import Correction, annotation_of, corrections_of, parsed_correction
from pam_cosim.simulation.models import describe
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
        corrections: values in place of what the data set states, and initial states.
    """

    model: str
    effects: tuple[str, ...]
    values: Mapping[str, float]
    constants: Mapping[str, float] = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    corrections: tuple[Correction, ...] = ()

    @property
    def of_the_model(self) -> dict[str, float]:
        """The values that a model can hold: those of its own parameters."""
        return {name: value for name, value in self.values.items() if not _of_the_data(name)}

    def stated(self, parameters: Collection[str]) -> dict[str, float]:
        """What the model's text states [SI]: constants that are among the base model's parameters, and its values."""
        return {n: v for n, v in self.constants.items() if n in parameters} | self.of_the_model

    @property
    def left_out(self) -> list[str]:
        """The values that neither the model's text nor its corrections can hold."""
        held_names = {correction.target for correction in self.corrections} | {
            correction.name for correction in self.corrections
        }
        return [
            name
            for name in self.values
            if _of_the_data(name) and parameter_of(name) not in held_names
        ]


def _of_the_data(name: str) -> bool:
    return "@" in name or is_ratio(name)


class _Final(BaseModel):
    """The model in a JSON document of parameters."""

    model: str = ""
    effects: tuple[str, ...] = ()
    constants: dict[str, FiniteFloat] = {}
    corrections: tuple[str, ...] = ()


def fitted_model(product: Diagnosis | Fit | Comparison) -> FittedModel:
    """What a diagnosis or a fit came to, or what was compared."""
    if isinstance(product, Comparison):
        corrections = corrections_of(product.data, product.parameters)
        return FittedModel(product.model, (), product.parameters, corrections=corrections)
    if isinstance(product, Diagnosis):
        effects, fit, data = tuple(c.effect for c in product.path), product.final, product.data
    else:
        effects, fit, data = (), product, product.comparison.data
    corrections = corrections_of(data, fit.values_and_starts)
    model = data.model if is_modelica(data.model) else product.model
    return FittedModel(model, effects, fit.values, data.constants, corrections=corrections)


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
        final = _Final.model_validate(content.get("final", content))
    except ValidationError as error:
        wrong = error.errors()[0]
        raise InputError(f"{'.'.join(map(str, wrong['loc']))}: {wrong['msg']}", path) from None
    corrections = tuple(filter(None, map(parsed_correction, final.corrections)))
    if not corrections:
        targets = [(*name.rpartition("@")[::2], value) for name, value in values.items()]
        corrections = tuple(Correction(n, value, run=run) for n, run, value in targets if n)
    return FittedModel(
        final.model, final.effects, values, final.constants, units_in(content), corrections
    )


def values_of_file(
    file: Path, data: DataSet, model: str | None, files: Sequence[Path]
) -> dict[str, float]:
    """The values of an earlier fit in a file [SI], looked at before they are used.

    Args:
        file: as ``read_fitted_model`` takes it.
        data: the measurement that they are used with.
        model: as requested; None: the bench of the data set.
        files: further Modelica files.

    Raises:
        InputError: values of a model with effects, or of another model, and none is named; as ``check_fitted``.
    """
    fitted = read_fitted_model(file)
    if fitted.effects and model is None:
        add_command = f"pam-cosim add --from {quote(str(file))} -o Better.mo"
        raise InputError(
            f"these values are of {fitted.model} with {', '.join(fitted.effects)}: name that model with --model; "
            f"'{add_command}' writes it",
            file,
        )
    interface = describe(data.model_for(model), files)
    matching_names = {"", data.model, data.bench, data.unmapped, names.last(interface.model)}
    if model is None and not matching_names & {fitted.model, names.last(fitted.model)}:
        raise InputError(
            f"these values are of {fitted.model}, and the data set is of {interface.model}: "
            "name the model that they are for with --model",
            file,
        )
    check_fitted(fitted, interface, file)
    return dict(fitted.values)


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
            variable = settable(parameter, interface)
            _check_unit(fitted.units.get(name, variable.unit), variable)
            value_of(value, variable)
        except InputError as problem:
            raise InputError(problem.message, file) from None


def compose_fitted(
    tree: ClassTree,
    fitted: FittedModel,
    name: str | None,
    parameters: Collection[str],
    files: Sequence[Path],
    class_text: str = "",
) -> Composition:
    """The Modelica class of a model with effects and values; its text is self-contained.

    Args:
        tree: the library with the user's files.
        fitted: the model.
        name: of the class; None: made from the names.
        parameters: names of all parameters of the base model.
        files: the user's files.
        class_text: text of classes that it uses, which its text then holds.

    Raises:
        InputError: an effect finds no place; a value is of none of the parameters; there is a class of that name.
    """
    values = fitted.stated(parameters)
    corrections = [
        c for c in fitted.corrections if c.run or c.stated is not None or c.name not in values
    ]
    composition = compose(
        tree,
        fitted.model,
        fitted.effects,
        name,
        files=files,
        values=values,
        annotation=annotation_of(corrections),
    )
    parameter_names = {
        *parameters,
        *(n for names in composition.parameters.values() for n in names),
    }
    stray = next((n for n in values if n not in parameter_names), None)
    if stray is not None:
        raise InputError(
            f"{composition.name} has no parameter '{stray}', of which there is a value"
        )
    if composition.name in tree.classes or composition.name in names.PREDEFINED:
        raise InputError(f"there is a class {composition.name} already: choose another name")
    if class_text:
        composition = replace(composition, text=f"{class_text.rstrip()}\n\n{composition.text}")
    return replace(composition, text=with_base(composition, fitted.model))


def with_base(composition: Composition, model: str) -> str:
    """The text of a model after that of the file whose model it extends; classes of packages are found by name."""
    if not is_modelica(model) or names.parent(composition.base):
        return composition.text
    return f"{read_file(Path(model), MOST_TEXT).decode('utf-8-sig').rstrip()}\n\n{composition.text}"
