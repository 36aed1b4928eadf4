"""Which examples of the Modelica Standard Library compile, and how far they are from OpenModelica's trajectories.

    python -m benchmarks.standard_library FOLDER/Modelica [--omc OMC] [--only PATTERN] [-o TABLE.md]

OpenModelica writes a CSV file for each example into the current folder; one that is there is not made again.
"""

from __future__ import annotations

import argparse
import csv
import re
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from pam_cosim.compiler.library import Library
from pam_cosim.compiler.syntax import ClassDefinition
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.simulation.models import describe, opened

PACKAGES = (
    "Mechanics.Translational",
    "Mechanics.Rotational",
    "Thermal.HeatTransfer",
    "Blocks",
    "Electrical.Analog",
)
_POINTS = 201
_LONGEST = 60.0  # [s] of processor time of a run
_EVENTS = re.compile(r"\b(when|pre|sample|edge|change|reinit)\b|an event does")


def examples(folder: Path) -> Iterator[str]:
    """Full names of the examples, in the order of the files."""
    library = Library(None, [folder])
    for name in PACKAGES:
        package = library.find(f"Modelica.{name}.Examples")
        if package is not None:
            yield from _examples_in(package)


def _examples_in(package: ClassDefinition) -> Iterator[str]:
    for node in package.classes.values():
        if node.kind == "package":
            yield from _examples_in(node)
        elif any(clause.type.text.endswith("Icons.Example") for clause in node.extends):
            yield node.qualified_name


def reference_of(model: str, folder: Path, omc: str) -> dict[str, np.ndarray] | None:
    """The trajectories of OpenModelica by variable; None: it has none."""
    file = Path(f"{model}_res.csv")
    if not file.exists() and omc:
        options = f'tolerance=1e-8, numberOfIntervals={_POINTS - 1}, outputFormat="csv"'
        _answer(f'simulate({model}, {options}, fileNamePrefix="{model}");', folder, omc)
    if not file.exists():
        return None
    with file.open() as opened_file:
        header, *rows = csv.reader(opened_file)
    values = np.array([[float(cell) for cell in row] for row in rows])
    return dict(zip(header, values.T, strict=True))


def _answer(command: str, folder: Path, omc: str) -> str:
    """What OpenModelica prints of a command, with the library loaded."""
    loads = [folder.parent / "Complex.mo", folder.parent / "ModelicaServices" / "package.mo"]
    lines = [f'loadFile("{one}");' for one in (*loads, folder / "package.mo")]
    Path("command.mos").write_text("\n".join([*lines, command]))
    run = subprocess.run([omc, "command.mos"], capture_output=True, text=True, check=False)
    return run.stdout


def _has_events(model: str, message: str, folder: Path, omc: str) -> bool:
    """Whether the flat model has events of its own, by the message of the compiler or by OpenModelica."""
    flat = _answer(f"instantiateModel({model});", folder, omc) if omc else ""
    return bool(_EVENTS.search(message) or _EVENTS.search(re.sub(r'"[^"\n]*"', "", flat)))


def deviation(model: str, folder: Path, reference: dict[str, np.ndarray]) -> tuple[float, int]:
    """The largest rms deviation of a variable over its range, and how many variables both tools have."""
    files, interface = [folder], describe(model, [folder])
    names = [n for n in interface.variables if n in reference and n not in interface.parameters]
    time_of_reference = reference["time"]
    stop = float(time_of_reference[-1])
    times = np.linspace(0.0, stop, _POINTS)
    with opened(model, files, brief=True, timeout=_LONGEST) as simulator:
        run = simulator.run(times, outputs=names, start_time=0.0, tolerance=1e-8)
    worst = 0.0
    last = np.append(
        np.diff(time_of_reference) > 0, True
    )  # of the values at an event those after it
    for name in names:
        theirs = np.interp(times, time_of_reference[last], reference[name][last])
        size = max(float(np.ptp(theirs)), 1e-3 * float(np.abs(theirs).max()), 1e-9)
        away = np.ones(times.size, dtype=bool)
        calm = np.abs(np.diff(theirs)) < 0.2 * size
        if calm.mean() > 0.9:  # a few steps, each at one sample more or less; no oscillation
            away[1:] &= calm
            away[:-1] &= calm
        worst = max(worst, float(np.sqrt(np.mean((run[name] - theirs)[away] ** 2))) / size)
    return worst, len(names)


def row(model: str, folder: Path, omc: str) -> str:
    """A line of the table."""
    begin = time.perf_counter()
    short = model.removeprefix("Modelica.")
    try:
        describe(model, [folder])
    except InputError as error:
        message = error.message.removeprefix(f"{model}: ").replace("|", "/")
        kind = "events" if _has_events(model, message, folder, omc) else "refused"
        return f"| {short} | {kind} | | {message[:110]} |"
    seconds = time.perf_counter() - begin
    reference = reference_of(model, folder, omc)
    if reference is None:
        return f"| {short} | compiles in {seconds:.1f} s | no reference | |"
    try:
        worst, count = deviation(model, folder, reference)
    except (InputError, SimulationFailure) as error:
        return f"| {short} | does not run | | {str(error)[:110]} |"
    agrees = "agrees" if worst < 1e-3 else "differs"
    return f"| {short} | {agrees} | {worst:.1e} of the range, {count} variables | |"


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--omc", default="")
    parser.add_argument("--only", default="")
    parser.add_argument("-o", "--output", type=Path)
    options = parser.parse_args()
    rows = ["| example | | deviation | refused because of |", "|---|---|---|---|"]
    for model in examples(options.folder):
        if re.search(options.only, model):
            rows.append(row(model, options.folder, options.omc))
            print(rows[-1], flush=True)
    counts = {
        kind: sum(f"| {kind}" in line for line in rows[2:])
        for kind in ("agrees", "differs", "events", "refused")
    }
    print(counts, len(rows) - 2)
    if options.output:
        options.output.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
