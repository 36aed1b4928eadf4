"""The command ``demo``."""

from __future__ import annotations

import time
from pathlib import Path
from shlex import quote
from typing import Annotated

import typer

from pam_cosim.cli.commands.common import (
    WorkersOption,
    check_results,
    console,
    follower,
    results,
    teller,
)
from pam_cosim.files import identity, make_folder
from pam_cosim.reporting import diagnosis_text
from pam_cosim.study import demonstration

TITLE = """Six runs of a muscle on a simulated rig. Its bladder has a spring law that neither the model nor the
catalogue contains. The model is refitted, its error is shown, and the missing effect is searched for."""


def demo(
    folder: Annotated[
        Path, typer.Argument(help="Where recordings and results go; made if needed.")
    ] = Path("pam-cosim-demo"),
    workers: WorkersOption = None,
) -> None:
    """Diagnose recordings that come along: see the verdict, the page, and the error fall."""
    results[folder / demonstration.DATA] = identity(folder / demonstration.DATA)
    data = demonstration.unpack(folder)
    make_folder(folder)
    check_results(*demonstration.results_of(folder, "report", "Better"))
    begin = time.perf_counter()
    typer.echo(f"{TITLE}\n")
    with console().status("refitting the base model") as status:
        shown = demonstration.demonstrate(
            data, folder, say=teller(status), progress=follower(status), workers=workers
        )
    typer.echo(diagnosis_text(shown.diagnosis))
    typer.echo(f"\n--- the model of the data set, as it was\n{shown.before}")
    typer.echo(f"\n--- the model with what was found, {shown.model}\n{shown.after}\n")
    lies = {
        "page, to be opened in a browser": shown.page,
        "picture of the error that falls": shown.picture,
        "verdict in numbers": shown.numbers,
        "model with the effect": shown.model,
        "recordings, as a data set": data,
    }
    for what, path in lies.items():
        typer.echo(f"{what:<32} {path}")
    by_hand = f"pam-cosim diagnose {quote(str(data))} --report report.html"
    typer.echo(f"{time.perf_counter() - begin:.0f} s. The same by hand: {by_hand}")
