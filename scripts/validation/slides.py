"""The slides, and shapes of muscles: Kang's force, the linear model's step, two lengths, three shapes."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Inputs, Simulator
from scripts.validation.drawing import COLOURS, figure, save, simulate, widths

SHAPES = {
    "CylindricalBraid": "cylinder",
    "ThreeElementShape": "two frustums, cylinder: DP (13)",
    "TothovaPitel": "barrel: DP (9)",
}
REACH = (
    0.164  # contraction ratio up to which the cones of DP Table 1 span the step from the connector
)


def two_lengths(folder: Path) -> list[str]:
    """AM Fig. 8."""
    cases = ((0.15, 0.2), (0.30, 0.2), (0.15, 2), (0.30, 2))
    r = simulate("Examples.Validation.TwoLengths", 10, 8001)
    picture, axes = figure(2, 8.0)
    late = r.time > 5
    for i, (length, _) in enumerate(cases):
        p, eps = r.values[f"p[{i + 1}]"][late] / 1e3, r.values[f"eps[{i + 1}]"][late] * 100
        axes[i // 2].plot(
            p,
            eps,
            color=COLOURS[i % 2],
            lw=1.2,
            ls="-" if i % 2 else "--",
            label=f"{length * 1e3:g} mm",
        )
    for a, f in zip(axes, (0.2, 2), strict=True):
        a.set(
            xlabel="gauge pressure [kPa]", ylabel="contraction ratio [%]", title=f"sine of {f:g} Hz"
        )
        a.legend()
    save(picture, folder, "two-lengths")
    a, b, c, d = widths("Examples.Validation.TwoLengths", 10, 40001, 3e5, 5.0)
    assert abs(a - b) < 5e-3
    return [
        f"share one loop at 0.2 Hz ({a:.2f} % of the length wide at 300 kPa)",
        f"at 2 Hz it is {c:.2f} and {d:.2f} %",
    ]


def force_grid(folder: Path) -> list[str]:
    """AM Figs. 5 to 7."""
    picture, (a, b) = figure(2, 8.0)
    eps = np.linspace(0, 0.3, 61)
    with Simulator(build_model("StaticForce")) as simulator:

        def force(p: np.ndarray, strain: np.ndarray) -> np.ndarray:
            course = np.arange(p.size, dtype=float)
            return simulator.run(course, inputs=Inputs(course, {"p": p, "eps": strain})).values["F"]

        for i, bar in enumerate((1.5, 3, 4.5, 6)):
            pull = np.maximum(force(np.full_like(eps, bar * 1e5), eps), 0)
            a.plot(100 * eps, pull, color=COLOURS[i], label=f"{bar:g} bar")
        p = np.linspace(4e5, 8e5, 41)
        here = force(
            np.array([6e5 - 10, 6e5 + 10, 6e5, 6e5, 6e5]),
            np.array([0.1, 0.1, 0.1 - 1e-5, 0.1 + 1e-5, 0.1]),
        )
        b.plot(
            p / 1e5, force(p, np.full_like(p, 0.1)), color=COLOURS[0], label="equation, 10 % strain"
        )
    slope, stiffness = (here[1] - here[0]) / 20, (here[2] - here[3]) / (2e-5 * 0.3)
    b.plot(
        p / 1e5,
        here[4] + slope * (p - 6e5),
        color=COLOURS[1],
        ls="--",
        label="its own slope at 6 bar",
    )
    b.plot(
        p / 1e5,
        here[4] + 5.7238e-5 * (p - 6e5),
        color=COLOURS[2],
        ls=":",
        label="slope printed in AM Fig. 7",
    )
    a.set(xlabel="contraction ratio [%]", ylabel="pull [N]")
    b.set(xlabel="gauge pressure [bar]", ylabel="pull [N]")
    a.legend()
    b.legend()
    save(picture, folder, "force-grid")
    return [
        f"the stated parameters give F = {here[4]:.2f} N, dF/dP = {slope * 1e4:.4f}e-4 m2, dF/dL = {stiffness:.1f} N/m"
    ]


def shapes(folder: Path) -> list[str]:
    """DP (9) and (13)."""
    picture, (a, b) = figure(2, 8.0)
    eps = np.linspace(0, 0.3, 121)
    at_10 = {}
    for i, (braid, name) in enumerate(SHAPES.items()):
        source = f"""model Shape{i} extends PneumaticMuscle.Benches.StaticForce(muscle(
          L0=0.24, D0=0.02, alpha_0=0.4823479, redeclare model Braid = PneumaticMuscle.Laws.Forces.{braid}));
          end Shape{i};"""
        reach = (
            eps[eps < REACH] if braid == "ThreeElementShape" else eps
        )  # its assertion ends a run beyond
        force, volume = _shape(f"Shape{i}", source, reach)
        a.plot(100 * reach, force, color=COLOURS[i], label=name)
        b.plot(100 * reach, volume * 1e6, color=COLOURS[i])
        at_10[braid] = float(np.interp(0.1, reach, force))
    for axes in (a, b):
        axes.axvspan(16.4, 30, color="0.85", zorder=0)
        axes.set(xlabel="contraction ratio [%]")
    b.text(16.8, 62, "DP (13) does not exist here", fontsize=7)
    a.set(ylabel="pull at 200 kPa [N]", ylim=(0, 420))
    b.set(ylabel="volume [mL]")
    a.legend(fontsize=8, loc="upper right")
    save(picture, folder, "shapes")
    return [
        f"({at_10['ThreeElementShape']:.1f} against {at_10['CylindricalBraid']:.1f} N at 200 kPa)"
    ]


def _shape(name: str, source: str, eps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    course = np.arange(eps.size, dtype=float)
    with Simulator(build_source(name, source)) as simulator:
        inputs = Inputs(course, {"p": np.full_like(eps, 2e5), "eps": eps})
        r = simulator.run(course, inputs=inputs, outputs=["F", "muscle.braid.V"])
    return r.values["F"], r.values["muscle.braid.V"]


def lumped_step(folder: Path) -> list[str]:
    """AM, dynamic step response."""
    r = simulate("Examples.LumpedStep", 1.5)
    picture, axes = figure(3)
    curves = (
        ("p", "gauge pressure [bar]", 1e-5),
        ("L", "length [mm]", 1e3),
        ("F", "change of pull [N]", 1),
    )
    for a, (name, label, factor) in zip(axes, curves, strict=True):
        y = r.values[name] * factor
        a.plot(r.time, y, color=COLOURS[0], label="model")
        for rate, mark, colour in ((10, "o", COLOURS[1]), (80, ".", COLOURS[2])):
            t = np.arange(0, 1.5, 1 / rate)
            a.plot(t, np.interp(t, r.time, y), mark, color=colour, ms=4, label=f"{rate} Hz")
        a.set(xlabel="time [s]", ylabel=label)
    axes[0].legend()
    save(picture, folder, "lumped-step")
    fine = simulate("Examples.LumpedStep", 1.5, 15001)
    settled, highest = fine.values["F"][-1], fine.values["F"].max()
    seen = {rate: _overshoot_seen(fine.time, fine.values["F"], rate) for rate in (10, 80)}
    shown = np.mean(seen[10] > 1.2 * settled)
    return [
        f"the pull overshoots to {highest:.1f} N and settles at {settled:.1f} N",
        f"shows more than a fifth of overshoot for {100 * shown:.0f} % of the phases that the clock may have, and "
        f"{seen[10].min():.1f} N, no overshoot at all, where the step falls on a sample; at 80 Hz at least "
        f"{seen[80].min():.1f} N is seen",
    ]


def _overshoot_seen(time: np.ndarray, force: np.ndarray, rate: float) -> np.ndarray:
    """The largest sample [N] by the phase of a clock that samples so often [Hz]."""
    phases = np.arange(0, 1 / rate, 1e-4)
    return np.array(
        [np.interp(np.arange(phase, time[-1], 1 / rate), time, force).max() for phase in phases]
    )
