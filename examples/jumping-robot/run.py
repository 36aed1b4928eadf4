"""The jumping robot, from the recordings to a report: python examples/jumping-robot/run.py [FOLDER WITH THE RAW DATA].

Without the raw data the tables in recordings/ are used as they are. Writes report.md and result.png in some minutes.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent)]

import jumps  # noqa: E402

import pam_cosim as pam  # noqa: E402
from examples.raw_data import asked_for, markdown_table, raw_folder  # noqa: E402
from pam_cosim import study  # noqa: E402
from pam_cosim.files import write_bytes, write_text  # noqa: E402
from pam_cosim.fitting import Fit  # noqa: E402
from pam_cosim.measurement import DataSet, FreeParameter, Run  # noqa: E402
from pam_cosim.reporting.style import image  # noqa: E402

BENCH = "SwitchedMuscle"
DEAD = 0.018  # s; before this nothing reaches the muscle
TUBE = 23.6e-6  # m3, 74 in of 0.1575 in, robot_config_2021-04-05.yaml
LINE = (FreeParameter("line.A", 2e-8, 5e-6, 4e-6), FreeParameter("line.V", 2e-7, 2e-4, TUBE))
DEAD_VOLUME = FreeParameter("deadVolume.V_d", 0, 2e-4, 2e-5)
DELAY = FreeParameter("valve.drive.dead_time", 1e-3, 0.05, 0.02)


@dataclass(frozen=True)
class Stage:
    """A model that is fitted: what was added to the bench, what is free, and what is known beyond the data set."""

    title: str
    effects: tuple[str, ...] = ()
    free: tuple[FreeParameter, ...] = ()
    zeroed: bool = False
    drooping: bool = True
    contracting: bool = True
    known: tuple[tuple[str, float], ...] = ()


FULL = ("FrictionLine", "ValveDelay", "PressureOffset", "DeadVolume")
STAGES = (
    Stage("valve and muscle"),
    Stage("+ tube, one orifice and one volume (`LongLine`)", ("LongLine",), LINE),
    Stage("+ tube with wall friction (`FrictionLine`)", FULL[:1], LINE),
    Stage("+ dead time of the valves (`ValveDelay`)", FULL[:2], (*LINE, DELAY)),
    Stage(
        "+ zero of the sensor (`PressureOffset`, as read before the start)",
        FULL[:3],
        (*LINE, DELAY),
        True,
    ),
    Stage("+ volume at the muscle's end (`DeadVolume`)", FULL, (*LINE, DELAY, DEAD_VOLUME), True),
)
FINAL = STAGES[-1]
COUNTER = (
    replace(FINAL, title="source pressure held at its first value (no droop)", drooping=False),
    replace(FINAL, title="muscle held at its length at rest", contracting=False),
    replace(
        FINAL,
        title="tube as an orifice that chokes (`LongLine`)",
        effects=("LongLine", *FULL[1:]),
        free=(*LINE, DELAY, DEAD_VOLUME),
    ),
    replace(
        FINAL,
        title="volume of the tube as documented, 23.6 mL",
        free=(LINE[0], DELAY, DEAD_VOLUME),
        known=(("line.V", TUBE),),
    ),
    replace(
        FINAL,
        title="gas with energy balance (`EnergyGas`)",
        effects=(*FULL, "EnergyGas"),
        free=(*LINE, DELAY, DEAD_VOLUME, FreeParameter("muscle.gas.h", 0.01, 500, 20)),
    ),
)


def prepared(run: Run, stage: Stage) -> Run:
    """The run with what the stage knows or leaves out."""
    inputs, parameters = dict(run.inputs), {**run.parameters, **dict(stage.known)}
    if stage.zeroed:
        early = run.time < run.time[np.argmax(run.inputs["u_in"] > 0)] + DEAD
        parameters["manometer.offset"] = float(np.nanmedian(run.measurements["p"][early]))
    if not stage.drooping:
        inputs["p_supply"] = np.full_like(
            run.time, np.median(run.inputs["p_supply"][run.time < DEAD])
        )
    if not stage.contracting:
        inputs["s"] = np.zeros_like(run.time)
    return replace(run, inputs=inputs, parameters=parameters)


def fitted(stage: Stage, folder: Path) -> Fit:
    """The stage's model fitted to the fit runs."""
    model = BENCH
    if stage.effects:
        model = str(folder / "Stage.mo")
        pam.add(stage.effects, to=BENCH, output=model)
    data = pam.read(HERE, model=model)
    free = {**data.fit, **{p.name: p for p in stage.free}}
    runs = tuple(prepared(run, stage) for run in data.runs)
    return study.fit(replace(data, fit=free, runs=runs))


def rms(fit: Fit, role: str) -> str:
    return f"{fit.comparison.scores[role]['p'].rmse / 1e3:.1f}"


def estimate(fit: Fit, name: str, scale: float, unit: str) -> str:
    e = fit.parameters[name]
    if e.at_bound:
        return f"{e.value * scale:.3g} {unit} (at its bound)"
    return f"{e.value * scale:.3g} {unit} ({e.low * scale:.3g} to {e.high * scale:.3g})"


def draw(first: Fit, last: Fit) -> None:
    """Every run with the first and the last model."""
    picture, axes = plt.subplots(
        2, 4, figsize=(13, 5.6), layout="constrained", sharex=True, sharey=True
    )
    for axis, a, b in zip(axes.flat, first.comparison.runs, last.comparison.runs, strict=False):
        t, zero = a.run.time, b.run.parameters["manometer.offset"] / 1e3
        axis.plot(t, a.run.measurements["p"] / 1e3 - zero, ".", color="0.4", ms=3, label="measured")
        axis.plot(
            t, a.model["p"] / 1e3 - zero, color="#d55e00", lw=1, ls="--", label="valve and muscle"
        )
        axis.plot(
            t,
            b.model["p"] / 1e3 - zero,
            color="#0072b2",
            lw=1.5,
            label="with tube, dead time, zero",
        )
        axis.set_title(f"{a.run.name.removeprefix('recordings/')} ({a.run.role})", fontsize=9)
        axis.grid(alpha=0.3)
    for axis in list(axes.flat)[len(first.comparison.runs) :]:
        axis.axis("off")
    axes[0, 0].legend(fontsize=7)
    picture.supxlabel("time [s]")
    picture.supylabel("pressure in the muscle [kPa gauge, zero taken off]")
    write_bytes(HERE / "result.png", image(picture, dpi=100))
    plt.close(picture)


def phases(fit: Fit) -> list[list[str]]:
    """Root mean square error by phase of the jump, fit and holdout [kPa]."""
    spans = {"filling (to 0.12 s)": (0, 0.12), "take-off (0.12 to 0.2 s)": (0.12, 0.2),
             "hold (0.2 to 0.32 s)": (0.2, 0.32), "venting (from 0.32 s)": (0.32, 1)}  # fmt: skip
    rows = []
    for title, (low, high) in spans.items():
        row = [title]
        for role in ("fit", "holdout"):
            parts = [
                (r.model["p"] - r.run.measurements["p"])[(r.run.time >= low) & (r.run.time < high)]
                for r in fit.comparison.runs
                if r.run.role == role
            ]
            error = np.concatenate(parts) / 1e3
            error = error[~np.isnan(error)]
            row += [f"{np.sqrt(np.mean(error**2)):.1f}", f"{np.mean(error):+.1f}"]
        rows.append(row)
    return rows


def tank_balance(data: DataSet) -> list[list[str]]:
    """Mass that the tank gave by its droop, adiabatic and isothermal [g]."""
    volume, gas, rows = 1.475e-3, 287.05 * 296.15, []
    for run in data.runs:
        if "knee" in run.name:
            continue
        p = run.inputs["p_supply"]
        drop = float(
            np.median(p[run.time < DEAD]) - np.median(p[(run.time > 0.2) & (run.time < 0.3)])
        )
        low, high = (f"{1e3 * drop * volume / (gas * k):.2f}" for k in (1.4, 1.0))
        rows.append([run.name.removeprefix("recordings/"), f"{drop / 1e3:.0f}", low, high])
    return rows


def report(diagnosis: pam.Diagnosis, stages: Sequence[Fit], counter: Sequence[Fit]) -> str:
    """The report in Markdown."""
    last = stages[-1]
    area = last.parameters["line.A"].value
    friction = (np.pi / 4 * 0.004**2 / area) ** 2 * 0.004 / (74 * 0.0254)
    steps = [
        [s.title, rms(f, "fit"), rms(f, "holdout")] for s, f in zip(STAGES, stages, strict=True)
    ]
    others = [
        [s.title, rms(f, "fit"), rms(f, "holdout")] for s, f in zip(COUNTER, counter, strict=True)
    ]
    added = [
        [c.effect, c.family, f"{c.fit.comparison.scores['fit']['p'].rmse / 1e3:.1f}"]
        for c in diagnosis.path
    ]
    return (
        (HERE / "report.template.md")
        .read_text(encoding="utf-8")
        .format(
            verdict=diagnosis.verdict.kind,
            probability=f"{100 * diagnosis.verdict.probability:.0f} %",
            named=", ".join(
                f"{name} = {value}" for name, value in diagnosis.final.parameters.items()
            ),
            reason=diagnosis.verdict.reason,
            added=markdown_table(["added", "family", "fit [kPa]"], added),
            hold=rms(diagnosis.final, "holdout"),
            steps=markdown_table(["model", "fit [kPa]", "holdout [kPa]"], steps),
            others=markdown_table(
                ["changed in the last model", "fit [kPa]", "holdout [kPa]"], others
            ),
            phases=markdown_table(
                ["phase", "fit rms", "fit mean", "holdout rms", "holdout mean"], phases(last)
            ),
            line=estimate(last, "line.A", 1e6, "mm2"),
            friction=f"{friction:.3f}",
            volume=estimate(last, "line.V", 1e6, "mL"),
            end=estimate(last, "deadVolume.V_d", 1e6, "mL"),
            dead=estimate(last, "valve.drive.dead_time", 1e3, "ms"),
            valve=estimate(last, "valve.C_A", 10, "mm2"),
            exponent=estimate(last, "muscle.n_g", 1, ""),
            tank=markdown_table(
                ["run", "droop [kPa]", "adiabatic [g]", "isothermal [g]"],
                tank_balance(last.comparison.data),
            ),
        )
    )


def main() -> None:
    raw = raw_folder("jumping-robot", asked_for())
    if raw is None:
        print("no raw data: the tables in recordings/ are used as they are")
    else:
        jumps.write_runs(HERE / "recordings", jumps.read_recordings(raw))
    with TemporaryDirectory() as place:
        stages = [fitted(stage, Path(place)) for stage in STAGES]
        counter = [fitted(stage, Path(place)) for stage in COUNTER]
    for stage, fit in zip((*STAGES, *COUNTER), (*stages, *counter), strict=True):
        print(
            f"{stage.title}: fit {rms(fit, 'fit')}, holdout {rms(fit, 'holdout')} kPa", flush=True
        )
    draw(stages[0], stages[-1])
    diagnosis = pam.diagnose(pam.read(HERE), say=lambda line: print(line, flush=True))
    print(diagnosis)
    write_text(HERE / "report.md", report(diagnosis, stages, counter))


if __name__ == "__main__":
    main()
