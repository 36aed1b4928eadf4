"""What the commands share: options, where results go, and the message of an interrupted command.

Every command loads it, so that it loads no room of the package by itself.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pam_cosim.files import (
    JSON,
    PAGE,
    PICTURE,
    TABLE,
    check_distinct,
    check_ending,
    check_spared,
    check_writable,
    identity,
)

if TYPE_CHECKING:
    from rich.console import Console

    from pam_cosim.analysis import FrequencyResponse, LinearModel, Observation
    from pam_cosim.diagnosis import Event, Message
    from pam_cosim.fitting import PredictiveBands
    from pam_cosim.measurement import DataSet
    from pam_cosim.problems import Problem

PARAMETERS = (".json", ".ssv")  # endings of results
PROGRESS = (".progress",)
INTERRUPTED = 130  # as shells have it for a command that Ctrl-C ended
results: dict[Path, object] = {}  # files that the command is to write, and what was there before
remarks: list[Callable[[], str]] = []  # what else an interrupted command has to say

ModelArgument = Annotated[
    str, typer.Argument(help="A bench, a Modelica class, a .mo or an .fmu file.")
]
ModelOption = Annotated[
    str | None, typer.Option("--model", help="A bench, a Modelica class, a .mo or an .fmu file.")
]
InputOption = Annotated[
    str | None,
    typer.Option(
        "--input",
        help="CSV with input columns: name [unit]; or formulas in time [s], 'u_in = 0.25 + 0.1*sin(6.28*time)'.",
    ),
]
FilesOption = Annotated[
    list[Path] | None,
    typer.Option(
        "--file", help="A .mo file or the folder of a package: own effects, rigs, library."
    ),
]
JsonOption = Annotated[
    Path | None, typer.Option("--json", help="Write the result as JSON, SI units.")
]
ReportOption = Annotated[
    Path | None, typer.Option("--report", help="Write a self-contained HTML report.")
]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        help='NAME=VALUE, with a unit such as "5 kg": a parameter, or an input held constant; NAME@RUN: of one run.',
    ),
]
RoleOption = Annotated[
    list[str] | None,
    typer.Option(
        "--role",
        help="RUN=fit or RUN=holdout, instead of the role in the data set; 'test*': all runs of such names.",
    ),
]
CutOption = Annotated[
    list[str] | None,
    typer.Option(
        "--cut",
        help='RUN=FROM:TO, such as run-03="2.5 s:": the part that is kept; "test*": of all runs of such names.',
    ),
]
BeginOption = Annotated[
    list[str] | None,
    typer.Option(
        "--begin",
        help="RUN=rest, steady, measured or estimated: how it begins; 'test*': these runs.",
    ),
]
FreeOption = Annotated[
    list[str] | None,
    typer.Option(
        "--free",
        help="Fit this parameter, and only those named so: of the data set, with bounds, or stated.",
    ),
]
StartOption = Annotated[
    list[str] | None,
    typer.Option(
        "--start",
        help="NAME=VALUE: where the fit of a parameter begins, with a unit. STATE@RUN: where a run begins.",
    ),
]
ParamsOption = Annotated[
    Path | None,
    typer.Option(
        "--params",
        help="Values of an earlier fit: of 'fit -o', 'diagnose --json', or a saved product.",
    ),
]
ValuesOption = Annotated[
    bool,
    typer.Option("--values", help="Print the value of every parameter, and where it comes from."),
]
WorkersOption = Annotated[
    int | None,
    typer.Option(help="Processes; default: all processors; 0: this process alone."),
]
TimeoutOption = Annotated[
    float | None,
    typer.Option(
        help="End a run that takes so many seconds of processor time (default: 30 and 0.01 for each row), or an .fmu "
        "that makes no progress for so long (default: 60); inf: never.",
        min=0.0,
    ),
]


def _drawable(width: str | None) -> str | None:
    """A width, checked before the work whose picture is to have it."""
    if width is not None:
        from pam_cosim.reporting.plots import inches_of  # half a second for matplotlib

        inches_of(width)
    return width


WidthOption = Annotated[
    str | None,
    typer.Option(
        "--width",
        callback=_drawable,
        help='Of the picture: "88mm" is a column of a journal; default: a page.',
    ),
]
KeepOption = Annotated[
    list[str] | None,
    typer.Option("--keep", help="Also record this variable; may be repeated."),
]
Data = Annotated[
    Path, typer.Argument(help="Folder of a data set, or what 'diagnose --save' wrote.")
]


@cache
def console() -> Console:
    """Standard error, for what changes while it is shown; loads rich."""
    from rich.console import Console

    return Console(stderr=True, highlight=False)


@contextmanager
def progress_bar(what: str, *columns: str) -> Iterator[Callable[[float, float], None]]:
    """Shows how much is done, of how much, on a terminal; elsewhere nothing, without rich.

    Args:
        what: stands before the bar.
        columns: of ``rich.progress``, after the bar.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich import progress

    extra_columns = [getattr(progress, f"{column}Column")() for column in columns]
    with progress.Progress(
        progress.TextColumn(what), progress.BarColumn(), *extra_columns, console=console()
    ) as bar:
        task = bar.add_task(what, total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)


def check_results(
    *outputs: Path | None,
    json: Path | None = None,
    report: Path | None = None,
    pictures: Iterable[Path | None] = (),
    tables: Iterable[Path | None] = (),
    sources: Iterable[Path | str | None] = (),
    files: Iterable[Path] | None = None,
    new_folder: bool = False,
) -> None:
    """Finds out before long work that the results can be written, and that nothing else is lost by that."""
    kinds = (
        ([json], "this is written as JSON", JSON),
        ([report], "reports are written as HTML", PAGE),
        (list(tables), "this is written as CSV", TABLE),
        (list(pictures), "pictures are drawn as PNG, SVG or PDF", PICTURE),
    )
    named = [path for path in outputs if path is not None]
    for paths, what, endings in kinds:
        for path in filter(None, paths):
            check_ending(path, what, endings)
            named.append(path)
    for path in named:
        check_writable(path, new_folder=new_folder)
        results[path] = identity(path)
    check_distinct(named)
    check_spared(named, [s for s in (*sources, *(files or ())) if s is not None])


def say_used_with(files: Iterable[Path]) -> None:
    """Prints what a written model is to be used together with."""
    words = " ".join(f"--file {quote(str(file))}" for file in files)
    if words:
        typer.echo(f"it is used together with what it is made from: {words}", err=True)


def read_data(
    data: Path,
    model: str | None,
    files: list[Path] | None,
    roles: list[str] | None = None,
    cuts: list[str] | None = None,
    begins: list[str] | None = None,
) -> DataSet:
    """The data set; no result may replace one of its files."""
    from pam_cosim import study
    from pam_cosim.cli.arguments import parse_cuts, parse_pairs

    read = study.read(
        data,
        model=model,
        files=files or [],
        roles=parse_pairs(roles),
        cuts=parse_cuts(cuts or []),
        starts=parse_pairs(begins),
    )
    saved = data.glob("workbench*") if data.is_dir() else ()  # a study, by the workbench
    check_spared(results, [data, read.model, *read.files, *saved])
    return read


def problem_of(
    data: DataSet,
    model: str | None = None,
    files: list[Path] | None = None,
    settings: list[str] | None = None,
    free: list[str] | None = None,
    start: list[str] | None = None,
    params: Path | None = None,
    values: bool = False,
) -> Problem:
    """The problem that the options of a command state; warns of stated values that do not count, and prints all values.

    Args:
        data: the measurement.
        model: of --model. files: of --file. settings: of --set. free: of --free. start: of --start.
        params: of --params. values: of --values.
    """
    from pam_cosim import study
    from pam_cosim.cli.arguments import parse_pairs

    earlier, origin = {}, ""
    if params is not None:
        from pam_cosim.study.fitted_model import values_of_file

        earlier, origin = values_of_file(params, data, model, files or []), params.name
    problem = study.problem(
        data,
        model,
        values=parse_pairs(settings),
        free=free,
        start=parse_pairs(start),
        fitted=earlier,
        files=files or [],
        origin=origin,
    )
    before = {note for run in data.runs for note in run.notes}
    notes = dict.fromkeys(note for run in problem.data.runs for note in run.notes)
    for note in notes:
        if note not in before:
            typer.echo(f"note: {note}", err=True)
    if values:
        typer.echo(f"{problem}\n")
    return problem


def say_written(*paths: Path | None) -> None:
    """Names results on standard error, those that were requested."""
    for path in filter(None, paths):
        typer.secho(f"written: {path}", dim=True, err=True)


def tell_and_write(
    product: LinearModel | FrequencyResponse | Observation | PredictiveBands,
    output: Path | None,
    json: Path | None,
    plot: Path | None,
    width: str | None,
) -> None:
    """Prints a product and writes it where that was requested: as CSV, as JSON and as a picture."""
    from pam_cosim import study

    typer.echo(str(product))
    if output:
        product.to_csv(output)
    if json:
        product.to_json(json)
    if plot:
        study.draw(product, plot, width)
    say_written(output, json, plot)


def interrupted() -> int:
    """Ends what the command has started and reports what it has written; the exit status."""
    if "pam_cosim.processes.workers" in sys.modules:  # who has not loaded it has started nothing
        from pam_cosim.processes.workers import stop_workers

        stop_workers()
    saved = [str(path) for path, before in results.items() if identity(path) not in (None, before)]
    what = f"written: {', '.join(saved)}" if saved else "nothing was written"
    more = "".join(f"; {text}" for text in (remark() for remark in remarks) if text)
    print(f"pam-cosim: interrupted; {what}{more}", file=sys.stderr)
    return INTERRUPTED


def follower(status: Any) -> Callable[[Event], None]:
    """Shows in the status line how many of how many are done, of what no line is printed."""

    from pam_cosim.diagnosis import EffectProbed

    def follow(event: Event) -> None:
        if isinstance(event, EffectProbed):
            status.update(event.status)

    return follow


def teller(status: Any) -> Callable[[Message], None]:
    """Prints what happens; the status line shows the last headline, and how many results came since."""
    from rich.markup import escape

    headline, count = "", 0

    def say(message: Message) -> None:
        nonlocal headline, count
        console().print(message, markup=False, soft_wrap=True)
        headline, count = (headline, count + 1) if message.detail else (escape(message), 0)
        status.update(f"{headline}: {count} done" if count else headline)

    return say
