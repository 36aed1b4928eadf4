"""The command ``predict``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from pam_cosim import study
from pam_cosim.cli.arguments import parse_pairs
from pam_cosim.cli.commands.common import (
    FilesOption,
    InputOption,
    JsonOption,
    ModelOption,
    SetOption,
    WidthOption,
    check_results,
    console,
    read_data,
    tell_and_write,
)
from pam_cosim.counts import MOST_SAMPLES
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit


def predict(
    source: Annotated[
        Path,
        typer.Argument(
            metavar="FITTED",
            help="A saved diagnosis or fit (.npz), or a data set, which is fitted first.",
        ),
    ],
    inputs: InputOption = None,
    settings: SetOption = None,
    run: Annotated[
        str | None, typer.Option(help="A recorded run instead, with its readings in the bands.")
    ] = None,
    stop_time: Annotated[
        str | None, typer.Option(help="End of the run, such as 20 or '2 min'; in s.")
    ] = None,
    interval: Annotated[
        str | None, typer.Option(help="Time between two rows of the result, such as '1 ms'.")
    ] = None,
    samples: Annotated[
        int,
        typer.Option(
            help="Of the parameters, each of which is simulated.", min=2, max=MOST_SAMPLES
        ),
    ] = 200,
    seed: Annotated[int, typer.Option(help="Of the samples.", min=0)] = 0,
    discrepancy: Annotated[
        bool,
        typer.Option(
            help="Add to the bands of readings the model error: sd in the signal's unit, "
            "memory in s, estimated from held-out runs, else from fitted ones."
        ),
    ] = True,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write values and bands as CSV, SI.")
    ] = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the signals with their bands.")] = None,
    width: WidthOption = None,
    json: JsonOption = None,
    model: ModelOption = None,
    files: FilesOption = None,
) -> None:
    """Predict a run that was not recorded, with 95 % bands of the parameter uncertainty."""
    check_results(
        json=json, tables=[output], pictures=[plot], sources=[source, model, inputs], files=files
    )
    product = _fitted(source, model, files)
    with console().status("simulating samples of the parameters"):
        bands = study.predict(
            product,
            inputs,
            parse_pairs(settings),
            run=run,
            stop_time=stop_time,
            interval=interval,
            samples=samples,
            seed=seed,
            discrepancy=discrepancy,
            files=files or [],
        )
    tell_and_write(bands, output, json, plot, width)


def _fitted(source: Path, model: str | None, files: list[Path] | None) -> Fit | Diagnosis:
    """The saved product, or the fit of a data set."""
    if source.suffix.lower() != ".npz":
        data = read_data(source, model, files)
        with console().status("fitting"):
            return study.fit(data, model, files=files or [])
    loaded = study.load(source)
    if not isinstance(loaded, Fit | Diagnosis):
        raise InputError(
            f"a {type(loaded).__name__} has no fitted parameters: name a diagnosis or a fit", source
        )
    return loaded
