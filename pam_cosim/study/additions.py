"""A model with further effects, as a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from pam_cosim.catalogue import Composition
from pam_cosim.compiler import read_library
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import check_model_file, write_text
from pam_cosim.fitting import Fit
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu, is_ratio, parameter_of, sources_of
from pam_cosim.model.settings import Setting, resolve
from pam_cosim.simulation.models import Paths, as_paths, describe
from pam_cosim.study.fitted_model import (
    FittedModel,
    check_fitted,
    compose_fitted,
    fitted_model,
    read_fitted_model,
)
from pam_cosim.study.products import load
from pam_cosim.wording import did_you_mean


def add(
    what: Sequence[str] | Diagnosis | Fit | Path,
    to: str | None = None,
    output: Path | str | None = None,
    *,
    values: Mapping[str, Setting] | None = None,
    files: Paths = (),
    learned: bool = False,
) -> str:
    """The Modelica text of a model with effects, or with what a diagnosis or a fit found; ``output`` is its file.

    ```python
    pam.add(diagnosis, output="Better.mo")  # with the fitted values: compare shows the errors of the verdict
    pam.add(["LinearBladder"], to="Isotonic", output="Better.mo")  # with default values
    ```

    Args:
        what: names of effects, which get their default values; or a product with fitted values, or the file of one:
            a saved diagnosis or fit, or the JSON or the parameters that a command wrote.
        to: the base model: a bench, a Modelica class or a ``.mo`` file. Default: the one that the product is of.
        output: a file that ends in ``.mo``; its name is that of the class.
        values: of parameters, before those of the product: numbers [SI] or texts with a unit.
        files: further Modelica files.
        learned: of a diagnosis, the model with the term that was learned, whose class stands in the text.

    Raises:
        InputError: an unknown effect, one that finds no place in the model, a value of a parameter that it lacks;
            the diagnosis has no learned term.
    """
    if not learned:
        origin = what if isinstance(what, Path) else None
        return _added(_fitted_model(what), to, output, values or {}, as_paths(files), origin=origin)
    diagnosis = load(what) if isinstance(what, Path) else what
    if not isinstance(diagnosis, Diagnosis) or diagnosis.learned is None:
        raise InputError(
            "this diagnosis has no learned term: only a saved diagnosis with the verdict unknown has one"
        )
    term, model = diagnosis.learned.term, diagnosis.learned.model
    fitted = FittedModel(diagnosis.model, model.effects, model.fit.values, diagnosis.data.constants)
    with TemporaryDirectory(prefix="pam-cosim-") as folder:
        file = Path(folder, f"{term.name}.mo")
        write_text(file, term.modelica_source)
        return _added(
            fitted, to, output, values or {}, [*as_paths(files), file], term.modelica_source
        )


def _added(
    fitted: FittedModel,
    to: str | None,
    output: Path | str | None,
    values: Mapping[str, Setting],
    files: Sequence[Path],
    class_text: str = "",
    origin: Path | None = None,
) -> str:
    """The text of a model with effects and values, with the text of further classes.

    Values that were read from a file, ``origin``, are looked at as those that are set.
    """
    if output:
        check_model_file(Path(output))
    base = to or fitted.model
    if not base or is_fmu(base):
        raise InputError("effects and values are added to a Modelica model: name it by to")
    ratio = next((parameter_of(effect) for effect in fitted.effects if is_ratio(effect)), None)
    if ratio is not None and not fitted.values:
        raise InputError(
            f"{ratio} corrects a stated value, which is no part of a model: correct it in the data set"
        )
    extra = sources_of(files, base)
    name = Path(output).stem if output else None
    parameters = describe(base, files).parameters if fitted.values else ()
    tree = read_library(files=extra)
    fitted = replace(fitted, model=base)
    if values or (origin is not None and fitted.values):
        bare = compose_fitted(tree, replace(fitted, values={}), name, parameters, files=extra)
        interface = _interface(bare, files)
        if origin is not None:
            check_fitted(fitted, interface, origin)
        fitted = replace(fitted, values={**fitted.values, **_resolved(values, interface)})
        parameters = (*parameters, *fitted.values)
    composition = compose_fitted(tree, fitted, name, parameters, files=extra, class_text=class_text)
    if output:
        write_text(Path(output), composition.text)
    return composition.text


def _interface(composition: Composition, files: Paths) -> Interface:
    """Of a composed model, which is no file yet."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"{composition.name}.mo"
        write_text(file, composition.text)
        return describe(str(file), files)


def _resolved(values: Mapping[str, Setting], interface: Interface) -> dict[str, float]:
    """Values of parameters of a model [SI]."""
    stray = next((name for name in values if name not in interface.parameters), None)
    if stray is not None:
        raise InputError(
            f"there is no parameter '{stray}'; {did_you_mean(stray, list(interface.parameters))}"
        )
    return resolve(values, interface)


def _fitted_model(source: Sequence[str] | Diagnosis | Fit | Path) -> FittedModel:
    if isinstance(source, Diagnosis | Fit):
        return fitted_model(source)
    if isinstance(source, Path):
        return read_fitted_model(source)
    return FittedModel("", tuple(source), {})
