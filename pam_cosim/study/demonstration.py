"""The first thing to try: a diagnosis of recordings that come along, and what it leaves as files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from pam_cosim import study
from pam_cosim.comparison import Comparison
from pam_cosim.diagnosis import Diagnosis, Listener, Message
from pam_cosim.errors import InputError
from pam_cosim.files import make_folder, write_bytes, write_json
from pam_cosim.reporting import diagnosis_report, draw, write_report
from pam_cosim.resources import demonstration_data

DATA = "data"  # folder of the recordings within that of the demonstration


@dataclass(frozen=True)
class Demonstration:
    """A diagnosis, the errors before and after, and where its files lie.

    Attributes:
        diagnosis: of the data set.
        before: the model of the data set against the recordings, as it was.
        after: the model with the effects that were found.
        page: the report. picture: how the error falls. numbers: the verdict as JSON. model: with the effects.
    """

    diagnosis: Diagnosis
    before: Comparison
    after: Comparison
    page: Path
    picture: Path
    numbers: Path
    model: Path


def results_of(output: Path, name: str, model: str) -> tuple[Path, Path, Path, Path]:
    """Paths of the page, picture, numbers and model that a demonstration writes."""
    return (
        output / f"{name}.html",
        output / f"{name}.png",
        output / f"{name}.json",
        output / f"{model}.mo",
    )


def demonstrate(
    data: Path,
    output: Path,
    name: str = "report",
    model: str = "Better",
    *,
    say: Callable[[Message], None] = lambda message: None,
    progress: Listener | None = None,
    workers: int | None = None,
) -> Demonstration:
    """Diagnoses a data set and writes report, figure, numbers and the model that has the effect.

    Args:
        data: folder of the data set.
        output: folder of the files, which is there.
        name: of the page, the picture and the numbers.
        model: name of the Modelica model.
        say: as in ``study.diagnose``.
        progress: as in ``study.diagnose``.
        workers: as in ``study.diagnose``.

    Raises:
        InputError: the data set cannot be used; a file cannot be written.
    """
    page, picture, numbers, better = results_of(output, name, model)
    read = study.read(data)
    diagnosis = study.diagnose(read, say=say, progress=progress, workers=workers)
    write_report(page, diagnosis_report(diagnosis))
    write_json(numbers, diagnosis.as_dict())
    draw(diagnosis, picture)
    study.add(diagnosis, output=better)
    before, after = study.compare(read), study.compare(read, str(better))
    return Demonstration(diagnosis, before, after, page, picture, numbers, better)


def unpack(folder: Path) -> Path:
    """Copies the recordings that come along into a folder and returns that of the data set.

    Args:
        folder: new, empty, or one of an earlier demonstration.

    Raises:
        InputError: the folder holds something else, or cannot be written.
    """
    ours = {DATA, *(path.name for path in results_of(folder, "report", "Better"))}
    if folder.exists() and not folder.is_dir():
        raise InputError("is a file; name a folder for the demonstration", folder)
    unrelated = (
        sorted(path.name for path in folder.iterdir() if path.name not in ours)
        if folder.exists()
        else []
    )
    if unrelated:
        raise InputError(
            f"holds {unrelated[0]}; name a new or an empty folder for the demonstration", folder
        )
    place = folder / DATA
    make_folder(place)
    for file in sorted(demonstration_data().iterdir()):
        if file.suffix in (".csv", ".toml"):
            write_bytes(place / file.name, file.read_bytes())
    return place
