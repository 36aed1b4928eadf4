"""An FMU that carries what it was judged by: fitted values, recordings and verdict; and the judgement, repeated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory

from pydantic import BaseModel, ConfigDict, FiniteFloat, ValidationError

from pam_cosim.comparison import Comparison
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.files import check_writable, json_text, make_folder, read_file, write_bytes
from pam_cosim.fitting.parameter_file import parameter_set
from pam_cosim.fmu.description import model_identifier
from pam_cosim.fmu.related_files import RelatedFile, related_files, with_related_files
from pam_cosim.measurement import DataSet
from pam_cosim.measurement.experiment import FILE_NAME
from pam_cosim.model.references import is_fmu
from pam_cosim.simulation.models import Paths, build, describe
from pam_cosim.study.additions import add_fitted
from pam_cosim.study.comparisons import compare
from pam_cosim.study.data_sets import read
from pam_cosim.study.fitted_model import FittedModel, fitted_model, read_fitted_model
from pam_cosim.study.products import load
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, printable

_DATA = "recordings/"
_VALUES, _JUDGED, _VERDICT, _SUMMARY = (
    "fitted.ssv",
    "diagnosis.npz",
    "verdict.json",
    "judgement.json",
)
_VALIDATION = "experiment/validation"
_TYPES = {".toml": "application/toml", ".csv": "text/csv", ".json": "application/json"}


class _Summary(BaseModel):
    """What was judged, and what came of it; a file in the FMU."""

    model_config = ConfigDict(strict=True, extra="ignore")

    version: int = 1
    model: str
    effects: list[str] = []
    values: dict[str, FiniteFloat] = {}
    verdict: str = ""
    rms: dict[str, dict[str, FiniteFloat]] = {}


@dataclass(frozen=True)
class Evidence(Printed):
    """What an FMU carries of its judgement.

    Attributes:
        fmu: the file.
        data: the recordings, as they were judged.
        model: the base model that the FMU was made from. effects: that were added to it.
        values: that were fitted, by name [SI]; also those of one run alone and ratios to what the data set states.
        verdict: in a sentence; empty: it was not diagnosed.
        rms: the errors [SI] by role and signal that it was written with.
    """

    fmu: Path
    data: DataSet
    model: str
    effects: tuple[str, ...]
    values: Mapping[str, float]
    verdict: str
    rms: Mapping[str, Mapping[str, float]]

    def __str__(self) -> str:
        effects = f" with {', '.join(self.effects)}" if self.effects else ""
        lines = [f"{self.fmu}: {self.model}{effects}, judged by {self.data.title}"]
        lines += [f"  verdict: {self.verdict}"] if self.verdict else []
        for role, errors in self.rms.items():
            if errors and role != "all":
                found = (
                    f"{n} {format_quantity(e, self.data.signals[n].unit)}"
                    for n, e in errors.items()
                )
                lines.append(f"  {role:8} rms error {', '.join(found)}")
        return "\n".join(lines)

    def compare(self, timeout: float | None = None) -> Comparison:
        """The FMU against its own recordings, with its own values."""
        return compare(self.data, str(self.fmu), self.values, timeout=timeout)

    def deviation(self, comparison: Comparison) -> float:
        """The largest relative difference of an error from the one that was written."""
        found = _errors(comparison)
        pairs = [
            (found[role][name], rms)
            for role, errors in self.rms.items()
            for name, rms in errors.items()
        ]
        return max(
            (abs(new - old) / max(abs(old), abs(new), 1e-300) for new, old in pairs), default=0.0
        )


def build_with_data(
    data: Path | str,
    output: Path | str,
    *,
    model: str | None = None,
    fit: Path | str | None = None,
    diagnosis: Path | str | None = None,
    files: Paths = (),
    platforms: Sequence[str] = ("native",),
    fmi: str = "2.0",
) -> Evidence:
    """Writes an FMU that carries its fitted values, the recordings it was judged by, and the verdict.

    ```python
    pam.build_with_data("my-rig", "Muscle.fmu", diagnosis="d.npz")
    print(pam.evidence("Muscle.fmu").compare())
    ```

    The judgement is made once with the finished FMU, from what is inside, before the file is put in its place.

    Args:
        data: folder of the data set.
        output: the FMU.
        model: the base model; default: that of the diagnosis, of the fit, or of the data set.
        fit: values, as a command or ``save`` wrote them.
        diagnosis: a saved diagnosis; its effects are in the model, and its values where there is no ``fit``.
        files: further Modelica files.
        platforms: as in ``build``.
        fmi: as in ``build``.

    Raises:
        InputError: what cannot be used; values of another model; nothing is written then.
    """
    check_writable(Path(output), new_folder=True)
    judged = _diagnosis(diagnosis)
    fitted = _fitted(judged, fit, model)
    read_first = read(data, model=None if fitted is None else fitted.model or None, files=files)
    fitted = fitted or FittedModel(read_first.model, (), {})
    # what the data set states of its rig is part of the model that leaves it: fitted values alone are no muscle
    fitted = replace(fitted, constants={**read_first.parameters, **fitted.constants})
    name = model_identifier(Path(output).stem)
    with TemporaryDirectory(prefix="pam-cosim-") as folder:
        made = _built(fitted, name, Path(folder), files, platforms, fmi)
        parts = _related(
            read_first, fitted, judged, None if diagnosis is None else Path(diagnosis), made
        )
        draft = Path(folder, f"{name}.fmu")
        write_bytes(
            draft, with_related_files(made.read_bytes(), [*parts, _summary(fitted, judged, {})])
        )
        rms = _errors(evidence(draft).compare())
        content = with_related_files(made.read_bytes(), [*parts, _summary(fitted, judged, rms)])
    make_folder(Path(output).parent)
    write_bytes(Path(output), content)
    return evidence(output)


def evidence(fmu: Path | str) -> Evidence:
    """What an FMU carries of its judgement.

    Raises:
        InputError: it carries none, or what cannot be read.
    """
    source = Path(fmu)
    files = {file.name: file for file in related_files(source)}
    if _SUMMARY not in files:
        raise InputError(
            "carries no recordings to be judged by: 'pam-cosim build --with-data' puts them in",
            source,
        )
    try:
        summary = _Summary.model_validate_json(files[_SUMMARY].content)
    except ValidationError as error:
        wrong = error.errors()[0]
        raise InputError(
            f"{_SUMMARY}: {'.'.join(map(str, wrong['loc']))}: {wrong['msg']}", source
        ) from None
    with TemporaryDirectory(prefix="pam-cosim-") as folder:
        data = read(_unpacked(files, Path(folder), source), model=str(source))
    return Evidence(
        source,
        data,
        summary.model,
        tuple(summary.effects),
        summary.values,
        printable(summary.verdict),
        summary.rms,
    )


def _diagnosis(path: Path | str | None) -> Diagnosis | None:
    if path is None:
        return None
    product = load(path)
    if not isinstance(product, Diagnosis):
        raise InputError(
            f"a {type(product).__name__} is no diagnosis: 'pam-cosim diagnose --save' writes one",
            path,
        )
    return product


def _fitted(
    judged: Diagnosis | None, fit: Path | str | None, model: str | None
) -> FittedModel | None:
    """Model, effects and values: of the diagnosis, with the values of the fit where there is one."""
    found = None if judged is None else fitted_model(judged)
    if fit is not None:
        values = read_fitted_model(Path(fit))
        if found is not None and values.effects and values.effects != found.effects:
            raise InputError(
                "its values are of a model with other effects than the diagnosis came to", fit
            )
        effects = values.effects if found is None else found.effects
        base = values.model if found is None else found.model
        constants = {} if found is None else found.constants
        found = FittedModel(model or base, effects, values.values, values.constants or constants)
    if found is None:
        return None if model is None else FittedModel(model, (), {})
    return FittedModel(model or found.model, found.effects, found.values, found.constants)


def _built(
    fitted: FittedModel, name: str, folder: Path, files: Paths, platforms: Sequence[str], fmi: str
) -> Path:
    """The FMU, whose start values are the fitted ones."""
    if is_fmu(fitted.model):
        return build(fitted.model, files=files, platforms=platforms, fmi=fmi)
    source = folder / f"{name}.mo"
    held = FittedModel(fitted.model, fitted.effects, fitted.of_the_model, fitted.constants)
    add_fitted(held, source, files)
    return build(str(source), files=files, platforms=platforms, fmi=fmi)


def _related(
    data: DataSet, fitted: FittedModel, judged: Diagnosis | None, saved: Path | None, fmu: Path
) -> list[RelatedFile]:
    """The files to carry, but for the summary."""
    found = []
    known = describe(str(fmu)).parameters
    values = {
        name: (value, known[name].unit)
        for name, value in fitted.stated(known).items()
        if name in known
    }
    if values:
        text = parameter_set(fitted.model, values).encode()
        kind = "application/x-ssp-parameter-set"
        found.append(
            RelatedFile(
                _VALUES,
                "parameter",
                kind,
                "Values that were stated of the rig, and fitted to the recordings",
                text,
            )
        )
    for file in dict.fromkeys(data.files):
        name = file.resolve().relative_to(data.folder.resolve()).as_posix()
        about = "Description of the recordings" if name == FILE_NAME else "A recording"
        kind = _TYPES.get(file.suffix.lower(), "application/octet-stream")
        found.append(RelatedFile(_DATA + name, _VALIDATION, kind, about, read_file(file)))
    if judged is not None and saved is not None:
        verdict = json_text(judged.as_dict()).encode()
        found.append(
            RelatedFile(_VERDICT, "report", _TYPES[".json"], "The diagnosis in numbers", verdict)
        )
        about = "The diagnosis with the samples that were judged"
        found.append(RelatedFile(_JUDGED, "result", "application/x-npz", about, read_file(saved)))
    return found


def _summary(
    fitted: FittedModel, judged: Diagnosis | None, rms: dict[str, dict[str, float]]
) -> RelatedFile:
    verdict = "" if judged is None else str(judged).splitlines()[0].removeprefix("Verdict: ")
    summary = _Summary(
        model=fitted.model,
        effects=list(fitted.effects),
        values=dict(fitted.values),
        verdict=verdict,
        rms=rms,
    )
    about = "What was judged, with which values, and the errors that came of it"
    return RelatedFile(
        _SUMMARY, "meta-data", _TYPES[".json"], about, summary.model_dump_json(indent=1).encode()
    )


def _errors(comparison: Comparison) -> dict[str, dict[str, float]]:
    return {
        role: {name: float(s.rmse) for name, s in scores.items()}
        for role, scores in comparison.scores.items()
    }


def _unpacked(files: Mapping[str, RelatedFile], folder: Path, fmu: Path) -> Path:
    """Writes the recordings into a folder and returns what to read: the samples as judged, or the data set."""
    if _JUDGED in files:
        target = folder / _JUDGED
        target.write_bytes(files[_JUDGED].content)
        return target
    if _DATA + FILE_NAME not in files:
        raise InputError("carries no recordings to be judged by", fmu)
    for name, file in files.items():
        if name.startswith(_DATA):
            target = folder.joinpath(*PurePosixPath(name).parts)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(file.content)
    return folder / _DATA
