"""Leak of printed chambers, and friction of an O-ring: python examples/chamber-leak/run.py [FOLDER WITH THE RAW DATA].

Without the raw data the tables in chambers/ and friction.csv are used as they are. Writes report.md and result.png.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent)]

import friction  # noqa: E402
import leak_tests  # noqa: E402

import pam_cosim as pam  # noqa: E402
from examples.raw_data import asked_for, markdown_table, raw_folder  # noqa: E402
from pam_cosim import study  # noqa: E402
from pam_cosim.files import write_bytes, write_text  # noqa: E402
from pam_cosim.fitting import Fit  # noqa: E402
from pam_cosim.measurement import FreeParameter  # noqa: E402
from pam_cosim.reporting.style import image  # noqa: E402

BENCH = "ClosedVessel"
CHAMBERS = HERE / "chambers"
VOLUME = 1e-4  # m3, assumed
GAS = 287.05 * 293.15  # J/kg
LAWS = {
    "LaminarLeak": FreeParameter("leak.G", 0, 1e-9, 1e-12),
    "OrificeLeak": FreeParameter("leak.A", 0, 2.5e-7, 1e-10),
}


@dataclass(frozen=True)
class Chamber:
    """One chamber: the fits without a leak and with either law."""

    name: str
    still: Fit
    laws: dict[str, Fit]


def fitted(folder: Path, law: str | None, work: Path) -> Fit:
    """The closed vessel with one law of leakage, or none, fitted to one chamber."""
    model = BENCH
    if law:
        model = str(work / f"{law}.mo")
        pam.add([law], to=BENCH, output=model)
    data = pam.read(folder, model=model)
    if law:
        data = replace(data, fit={**data.fit, LAWS[law].name: LAWS[law]})
    else:
        data = replace(data, fit={n: p for n, p in data.fit.items() if n != "tank.n"})
    return study.fit(data, model)


def rms(fit: Fit) -> float:
    return fit.comparison.scores["fit"]["p"].rmse


def free_air(chamber: Chamber) -> float:
    """Leak at 7 bar by volume of the chamber [free litres per minute and litre]."""
    g = chamber.laws["LaminarLeak"].parameters["leak.G"].value
    return g * 7e5 * GAS / 101325 / VOLUME * 60


def time_constant(chamber: Chamber) -> float:
    """Volume by conductance of the laminar law, isothermal [s]."""
    return VOLUME / (chamber.laws["LaminarLeak"].parameters["leak.G"].value * GAS)


def row(chamber: Chamber) -> list[str]:
    p = chamber.still.comparison.runs[0].run.measurements["p"] / 1e5
    scores = {name: fit.comparison.chi2_reduced("fit") for name, fit in chamber.laws.items()}
    return [
        chamber.name, f"{p[0]:.3f}", f"{1e3 * (p[0] - p[-1]):.0f}", f"{rms(chamber.still) / 100:.1f}",
        f"{rms(chamber.laws['LaminarLeak']) / 100:.2f}", f"{rms(chamber.laws['OrificeLeak']) / 100:.2f}",
        f"{scores['LaminarLeak']:.2f}, {scores['OrificeLeak']:.2f}", f"{time_constant(chamber):.3g}",
        f"{free_air(chamber):.2g}",
    ]  # fmt: skip


HEAD = ["chamber", "start [bar]", "lost [mbar]", "no leak [mbar]", "laminar [mbar]", "orifice [mbar]",
        "chi2 (laminar, orifice)", "time constant [s]", "free L/min per L at 7 bar"]  # fmt: skip


def draw(chambers: list[Chamber], strokes: list[friction.Stroke]) -> None:
    """The emptied chamber, the tight ones, and the friction."""
    picture, (a, b, c) = plt.subplots(1, 3, figsize=(13, 3.9), layout="constrained")
    emptied = next(x for x in chambers if x.name == leak_tests.EMPTIED)
    run = emptied.still.comparison.runs[0].run
    a.semilogy(run.time, run.measurements["p"] / 1e5, ".", color="0.4", label="measured")
    for (law, fit), colour in zip(emptied.laws.items(), ("#0072b2", "#d55e00"), strict=True):
        a.semilogy(run.time, fit.comparison.runs[0].model["p"] / 1e5, color=colour, label=law)
    a.set(xlabel="time [s]", ylabel="pressure [bar]", title=emptied.name, ylim=(1e-2, 10))
    a.legend()
    for i, chamber in enumerate(x for x in chambers if x is not emptied):
        r = chamber.laws["LaminarLeak"].comparison.runs[0]
        start = r.run.measurements["p"][0]
        b.plot(r.run.time, (r.run.measurements["p"] - start) / 100, ".", color=f"C{i}", ms=3)
        b.plot(r.run.time, (r.model["p"] - start) / 100, color=f"C{i}", label=chamber.name)
    b.set(
        xlabel="time [s]",
        ylabel="pressure since the start [mbar]",
        title="tight chambers, laminar leak",
    )
    b.legend(fontsize=7)
    p = [s.pressure for s in strokes]
    slope, base = friction.line(strokes)
    c.plot(p, [s.friction for s in strokes], "o", color="0.3")
    c.plot(
        [0, 7.5],
        [base, base + 7.5 * slope],
        color="#0072b2",
        label=f"{base:.1f} N + {slope:.2f} N/bar",
    )
    c.set(
        xlabel="pressure [bar]",
        ylabel="friction of the O-ring [N]",
        title="half the difference of the strokes",
        ylim=(0, None),
    )
    c.legend()
    for axis in (a, b, c):
        axis.grid(alpha=0.3)
    write_bytes(HERE / "result.png", image(picture, dpi=100))
    plt.close(picture)


def report(
    chambers: list[Chamber], diagnosis: pam.Diagnosis, strokes: list[friction.Stroke]
) -> str:
    """The report in Markdown."""
    slope, base = friction.line(strokes)
    emptied = next(x for x in chambers if x.name == leak_tests.EMPTIED)
    laminar, orifice = (rms(emptied.laws[law]) / 1e3 for law in ("LaminarLeak", "OrificeLeak"))
    n = emptied.laws["LaminarLeak"].parameters["tank.n"]
    return (
        (HERE / "report.template.md")
        .read_text(encoding="utf-8")
        .format(
            table=markdown_table(HEAD, [row(c) for c in chambers]),
            laminar=f"{laminar:.2f}",
            orifice=f"{orifice:.1f}",
            n=f"{n.value:.3f} ({n.low:.3f} to {n.high:.3f})",
            verdict=diagnosis.verdict.kind,
            probability=f"{100 * diagnosis.verdict.probability:.0f} %",
            reason=diagnosis.verdict.reason,
            final=", ".join(f"{k} = {v}" for k, v in diagnosis.final.parameters.items()),
            friction=markdown_table(friction.HEAD, [s.row() for s in strokes]),
            base=f"{base:.1f}",
            slope=f"{slope:.2f}",
            worst=f"{max(abs(s.friction - base - slope * s.pressure) for s in strokes):.2f}",
        )
    )


def main() -> None:
    raw = raw_folder("leak-and-friction-cylinder", asked_for())
    if raw is None:
        print("no raw data: the tables here are used as they are")
    else:
        leak_tests.write_chambers(raw, CHAMBERS)
        friction.write_strokes(raw, HERE / "friction.csv")
    chambers = []
    with TemporaryDirectory() as place:
        for folder in sorted(p for p in CHAMBERS.iterdir() if p.is_dir()):
            laws = {law: fitted(folder, law, Path(place)) for law in LAWS}
            chambers.append(Chamber(folder.name, fitted(folder, None, Path(place)), laws))
            print(*row(chambers[-1]), sep="  ", flush=True)
    strokes = friction.read_strokes(HERE / "friction.csv")
    draw(chambers, strokes)
    diagnosis = pam.diagnose(
        pam.read(CHAMBERS / leak_tests.EMPTIED), say=lambda line: print(line, flush=True)
    )
    print(diagnosis)
    write_text(HERE / "report.md", report(chambers, diagnosis, strokes))


if __name__ == "__main__":
    main()
