"""Words to calls: the command ``pam-cosim``. No logic of its own."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from shlex import quote
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from pam_cosim import study
from pam_cosim.arguments import fmu_files, parse_settings, parse_variations, read_inputs
from pam_cosim.comparison import Comparison
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.workers import stop_workers
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import check_distinct, check_spared, check_writable, identity, write_json, write_text
from pam_cosim.fitting import METHODS, FitOptions, read_parameters, summary, write_parameters
from pam_cosim.measurement import DataSet
from pam_cosim.quantities import readable
from pam_cosim.reporting import comparison_report, diagnosis_report, diagnosis_text, plot_trajectory, write_report
from pam_cosim.tables import against_lines, read_comparison, write_next_run, write_sweep

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Compare models with measurements and find the physical effect they lack.",
)
INTERRUPTED = 130  # as shells have it for a command that Ctrl-C ended
_results: dict[Path, object] = {}  # files that the command is to write, and what was there before
_console = Console(stderr=True, highlight=False)

ModelOption = Annotated[str | None, typer.Option("--model", help="A bench, a Modelica class, a .mo or an .fmu file.")]
FilesOption = Annotated[
    list[Path] | None, typer.Option("--file", help="A .mo file or the folder of a package: own effects, rigs, library.")
]
JsonOption = Annotated[Path | None, typer.Option("--json", help="Write the result as JSON, SI units.")]
ReportOption = Annotated[Path | None, typer.Option("--report", help="Write a self-contained HTML report.")]
SetOption = Annotated[
    list[str] | None,
    typer.Option("--set", help='NAME=VALUE, with a unit such as "5 kg": a parameter, or an input held constant.'),
]
TimeoutOption = Annotated[
    float | None,
    typer.Option(help="End an .fmu that makes no progress for so many seconds; default 60, inf: never.", min=0.0),
]
Data = Annotated[Path, typer.Argument(help="Folder with experiment.toml and CSV files.")]


def _checked(*outputs: Path | None, sources: Iterable[Path | str | None] = (), new_folder: bool = False) -> None:
    """Finds out before long work that the results can be written, and that nothing else is lost by that."""
    named = [path for path in outputs if path is not None]
    for path in named:
        check_writable(path, new_folder=new_folder)
        _results[path] = identity(path)
    check_distinct(named)
    check_spared(named, [source for source in sources if source is not None])


def _read(data: Path, model: str | None, files: list[Path] | None) -> DataSet:
    """The data set; no result may replace one of its files."""
    read = study.read(data, model=model, files=files or [])
    check_spared(_results, [read.model, *read.files])
    return read


def _saved(path: Path | None) -> None:
    if path is not None:
        _console.print(f"written: {path}", style="dim", markup=False, soft_wrap=True)


@app.command()
def build(
    models: Annotated[list[str] | None, typer.Argument(help="Models to build; default: every bench.")] = None,
    files: FilesOption = None,
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for the FMUs, or NAME.fmu for one.")] = Path(
        "fmu/build"
    ),  # fmt: skip
    platforms: Annotated[
        list[str] | None, typer.Option("--platform", help="native, all, or x86_64-windows ...")
    ] = None,
    fmi: Annotated[str, typer.Option("--fmi", help="Version of the interface: 2.0 or 3.0.")] = "2.0",
    sensitivities: Annotated[
        list[str] | None,
        typer.Option("--sensitivity", help="A parameter; the outputs' derivatives by it become outputs too."),
    ] = None,
) -> None:
    """Modelica to FMU."""
    targets = fmu_files(models or study.benches(), output)
    _checked(*(target for _, target in targets), sources=[*(models or []), *(files or [])], new_folder=True)
    for model, target in targets:
        made = study.build(
            model,
            target,
            files=files or [],
            platforms=platforms or ["native"],
            fmi=fmi,
            sensitivities=sensitivities or [],
        )
        typer.echo(made)


@app.command()
def simulate(
    model: Annotated[str, typer.Argument(help="A bench, a Modelica class, a .mo or an .fmu file.")],
    settings: SetOption = None,
    inputs: Annotated[Path | None, typer.Option("--input", help="CSV with input columns: name [unit].")] = None,
    stop_time: Annotated[float | None, typer.Option(help="End of the run [s].")] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the trajectory as CSV.")] = None,
    plot: Annotated[Path | None, typer.Option(help="Draw the outputs as PNG.")] = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """One run of a model."""
    _checked(output, plot, sources=[model, inputs, *(files or [])])
    interface = study.describe(model, files or [])
    parameters = parse_settings(settings or [], interface)
    course = read_inputs(inputs, interface) if inputs else None
    trajectory = study.simulate(model, parameters, course, stop_time=stop_time, files=files or [], timeout=timeout)
    for warning in trajectory.warnings:
        typer.echo(f"pam-cosim: {warning}", err=True)
    if output:
        trajectory.to_csv(output)
    if plot:
        plot_trajectory(trajectory, plot)
    for name, values in trajectory.values.items():
        unit = trajectory.units[name]
        low, high, last = (readable(float(v), unit) for v in (values.min(), values.max(), values[-1]))
        typer.echo(f"{name}: from {low} to {high}, at the end {last}")
    _saved(output)
    _saved(plot)


@app.command()
def sweep(
    model: Annotated[str, typer.Argument(help="A bench, a Modelica class, a .mo or an .fmu file.")],
    vary: Annotated[list[str], typer.Option("--vary", help="NAME=FROM:TO:N or NAME=A,B,C: a parameter, or an input.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="Write all trajectories as one CSV.")],
    settings: SetOption = None,
    inputs: Annotated[Path | None, typer.Option("--input", help="CSV with input columns: name [unit].")] = None,
    stop_time: Annotated[float | None, typer.Option(help="End of each run [s].")] = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Every combination of varied parameters and inputs."""
    _checked(output, sources=[model, inputs, *(files or [])])
    interface = study.describe(model, files or [])
    variations = parse_variations(vary, interface)
    parameters = parse_settings(settings or [], interface)
    course = read_inputs(inputs, interface) if inputs else None
    columns = (TextColumn("sweep"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=_console, disable=not _console.is_terminal) as progress:
        task = progress.add_task("sweep", total=None)
        points = study.sweep(
            model,
            variations,
            parameters=parameters,
            inputs=course,
            stop_time=stop_time,
            files=files or [],
            timeout=timeout,
            progress=lambda done, total: progress.update(task, completed=done, total=total),
        )
    write_sweep(output, points, interface)
    failed = [p for p in points if p.failure]
    for p in failed:
        _console.print(f"failed at {p.parameters}: {p.failure}", markup=False, soft_wrap=True)
    typer.echo(f"{len(points) - len(failed)} of {len(points)} runs done")
    _saved(output)


@app.command()
def compare(
    data: Data,
    model: ModelOption = None,
    params: Annotated[Path | None, typer.Option(help="Fitted parameters, from 'fit -o'.")] = None,
    against: Annotated[list[Path] | None, typer.Option(help="Earlier 'compare --json' results.")] = None,
    json: JsonOption = None,
    report: ReportOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """How far a model is from a measurement, and where."""
    _checked(json, report, sources=[model, params, *(against or []), *(files or [])])
    values = read_parameters(params) if params else {}
    earlier = [(path.stem, read_comparison(path)) for path in against or []]
    read = _read(data, model, files)
    found: Comparison = study.compare(read, model, values, files=files or [], timeout=timeout)
    typer.echo(str(found))
    for line in against_lines(found, earlier):
        typer.echo(line)
    if json:
        write_json(json, found.as_dict())
    if report:
        write_report(report, comparison_report(found))
    _saved(json)
    _saved(report)


@app.command()
def fit(
    data: Data,
    model: ModelOption = None,
    method: Annotated[
        str, typer.Option(help="How to search. " + "; ".join(f"{name}: {summary(name)}" for name in METHODS) + ".")
    ] = FitOptions.method,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the parameters (.json, .ssv).")] = None,
    json: JsonOption = None,
    files: FilesOption = None,
    timeout: TimeoutOption = None,
) -> None:
    """Fit the parameters that the data set leaves free."""
    _checked(output, json, sources=[model, *(files or [])])
    read = _read(data, model, files)
    with _console.status("fitting") as status:
        found = study.fit(
            read,
            model,
            method=method,
            files=files or [],
            timeout=timeout,
            progress=lambda n, chi2: status.update(f"fitting: {n} simulations, chi2 {chi2:.4g}"),
        )
    typer.echo(str(found))
    if output:
        write_parameters(output, found)
    if json:
        write_json(json, found.as_dict())
    _saved(output)
    _saved(json)


@app.command()
def diagnose(
    data: Data,
    model: ModelOption = None,
    json: JsonOption = None,
    report: ReportOption = None,
    following: Annotated[
        Path | None, typer.Option("--next", help="Write the next experiment's inputs as CSV, if there is one to make.")
    ] = None,
    learned: Annotated[
        Path | None, typer.Option("--learned", help="Write the formula for what no effect explains as Modelica.")
    ] = None,
    files: FilesOption = None,
    workers: Annotated[int | None, typer.Option(help="Processes; default: all processors.")] = None,
) -> None:
    """Find the physical effect that the model lacks."""
    _checked(json, report, following, learned, sources=[model, *(files or [])])
    if learned is not None and learned.suffix != ".mo":
        raise InputError("the formula is written as Modelica: name a file that ends in .mo", learned)
    read = _read(data, model, files)
    with _console.status("refitting the base model") as status:
        say = _teller(status)
        found = study.diagnose(read, model, files=files or [], say=say, workers=workers)
    typer.echo(diagnosis_text(found))
    if json:
        write_json(json, found.as_dict())
    if report:
        write_report(report, diagnosis_report(found))
    _saved(json)
    _saved(report)
    _write_advice(found, following, learned)


def _write_advice(found: Diagnosis, following: Path | None, learned: Path | None) -> None:
    """What a verdict leaves to do, as files, where there is something to do."""
    if following is not None:
        if found.next_experiment is None:
            typer.echo(f"no next experiment: the verdict is {found.verdict.kind}; {following} is not written")
        else:
            write_next_run(following, found.next_experiment)
            _saved(following)
    if learned is not None:
        if found.learned is None:
            typer.echo(f"nothing was learned: the verdict is {found.verdict.kind}; {learned} is not written")
        else:
            write_text(learned, found.learned.term.modelica_source)
            _saved(learned)


def _teller(status: Any) -> Callable[[str], None]:
    """Prints what happens; the status line shows the last headline, and how many results came since."""
    headline, count = "", 0

    def say(text: str) -> None:
        nonlocal headline, count
        _console.print(text, markup=False, soft_wrap=True)
        headline, count = (headline, count + 1) if text.startswith(" ") else (escape(text), 0)
        status.update(f"{headline}: {count} done" if count else headline)

    return say


@app.command()
def add(
    effects: Annotated[list[str], typer.Argument(help="Effects, by the names in 'pam-cosim effects'.")],
    to: Annotated[str, typer.Option("--to", help="The model: a bench, a Modelica class or a .mo file.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The Modelica file to write.")],
    files: FilesOption = None,
) -> None:
    """Write a readable Modelica model that extends another with effects."""
    _checked(output, sources=[to, *(files or [])])
    if output.suffix != ".mo":
        raise InputError("the model is written as Modelica: name a file that ends in .mo", output)
    typer.echo(study.add(effects, to, output, files=files or []), nl=False)
    _saved(output)
    own = [str(file) for file in files or []] + ([to] if to.endswith(".mo") else [])
    if own:
        words = " ".join(f"--file {quote(file)}" for file in own)
        _console.print(f"it is used together with what it is made from: {words}", markup=False, soft_wrap=True)


@app.command()
def effects(files: FilesOption = None) -> None:
    """The catalogue of effects."""
    listed = study.effects(files or [])
    for library in dict.fromkeys(e.library for e in listed):
        table = Table("family", "effect", "balance", "parameters", "what it is", title=escape(library))
        for e in listed:
            if e.library == library:
                cells = (e.family, e.name, e.balance, ", ".join(e.parameters), e.description)
                table.add_row(*map(escape, cells))
        Console(width=None if sys.stdout.isatty() else 160).print(table)


def main(arguments: list[str] | None = None) -> int:
    """Runs the command; 0 when done, 2 when the input cannot be used, 1 when a simulation failed, 130 on Ctrl-C."""
    _results.clear()
    try:
        app(args=arguments)
    except KeyboardInterrupt:
        return interrupted()
    except SystemExit as end:  # typer has printed its own message for words it does not know
        code = end.code if isinstance(end.code, int) else 1
        return interrupted() if code == INTERRUPTED else code
    except InputError as problem:
        print(f"pam-cosim: {problem}", file=sys.stderr)
        return 2
    except SimulationFailure as failure:
        print(f"pam-cosim: the simulation failed: {failure}", file=sys.stderr)
        return 1
    return 0


def interrupted() -> int:
    """Ends what the command has started and says what it has written; the status for it."""
    stop_workers()
    saved = [str(path) for path, before in _results.items() if identity(path) not in (None, before)]
    what = f"written: {', '.join(saved)}" if saved else "nothing was written"
    print(f"pam-cosim: interrupted; {what}", file=sys.stderr)
    return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
