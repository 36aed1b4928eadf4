"""Draws the validation models to docs/pictures and prints the figures that docs/validation.md quotes.

Run as ``python scripts/pictures.py``; takes about half a minute the first time.
"""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Inputs, Simulator, Trajectory

PICTURES = Path(__file__).parent.parent / "docs" / "pictures"
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")  # told apart by colour-blind readers

plt.rcParams.update(
    {"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False}
)


def simulate(model: str, end: float, samples: int = 2001, **parameters: float) -> Trajectory:
    with Simulator(build_model(f"PneumaticMuscle.{model}")) as simulator:
        return simulator.run(np.linspace(0, end, samples), parameters=parameters)


def figure(columns: int, width: float = 9.0, height: float = 3.2) -> tuple[plt.Figure, list[Axes]]:
    picture, axes = plt.subplots(1, columns, figsize=(width, height), layout="constrained", squeeze=False)
    return picture, list(axes[0])


def save(picture: plt.Figure, name: str) -> None:
    picture.savefig(PICTURES / f"{name}.png", dpi=110)
    plt.close(picture)


def say(what: str, *numbers: float, unit: str = "") -> None:
    print(f"  {what}: {', '.join(f'{n:.4g}' for n in numbers)} {unit}")


def rise_time(t: np.ndarray, x: np.ndarray) -> float:
    """From 10 % to 90 % of the last value [s]; x must rise."""
    reached = np.maximum.accumulate(x / x[-1])
    return float(np.interp(0.9, reached, t) - np.interp(0.1, reached, t))


def polytropic_exponent() -> None:
    print("polytropic exponent 1, 1.2, 1.4")
    r = simulate("Validation.PolytropicExponent", 10)
    picture, (a, b, c) = figure(3)
    for i, n in enumerate((1.0, 1.2, 1.4)):
        key, style = f"[{i + 1}]", {"color": COLOURS[i], "label": f"$n_g$ = {n:g}"}
        a.plot(r.time, r.values["p" + key] / 1e3, **style)
        a.plot(r.time, r.values["p_printed" + key] / 1e3, color=COLOURS[i], ls="--", lw=1)
        b.plot(r.time, r.values["x" + key] * 1e3, **style)
        b.plot(r.time, r.values["x_printed" + key] * 1e3, color=COLOURS[i], ls="--", lw=1)
        c.plot(r.time, r.values["T" + key] - 273.15, **style)
    a.set(xlabel="time [s]", ylabel="gauge pressure [kPa]", title="solid: films of air\ndashed: DP (45) as printed")
    b.set(xlabel="time [s]", ylabel="contraction [mm]")
    c.set(xlabel="time [s]", ylabel="gas temperature [°C]", title="films of air")
    a.legend()
    save(picture, "polytropic-exponent")
    at = [int(np.searchsorted(r.time, t)) for t in (1.0, 4.9, 6.0)]
    for i in range(3):
        key = f"[{i + 1}]"
        say("p at 1, 4.9, 6 s", *(r.values["p" + key][at] / 1e3), unit="kPa")
        say("x at 1, 4.9, 6 s", *(r.values["x" + key][at] * 1e3), unit="mm")
        say("T highest", r.values["T" + key].max() - 273.15, unit="degC")
        say("as printed: p at 4.9 s", r.values["p_printed" + key][at[1]] / 1e3, unit="kPa")
        say("as printed: x at 4.9 s", r.values["x_printed" + key][at[1]] * 1e3, unit="mm")


def bladder_friction() -> None:
    print("bladder friction 0.015, 0.04 (butyl)")
    r = simulate("Validation.BladderFriction", 10)
    picture, (a,) = figure(1, 4.6)
    for i, mu in enumerate((0.015, 0.04)):
        x = r.values[f"x[{i + 1}]"] * 1e3
        a.plot(r.time, x, color=COLOURS[i], label=rf"$\mu_{{fb}}$ = {mu:g}")
        say("steady contraction", x[np.searchsorted(r.time, 4.9)], unit="mm")
    a.set(xlabel="time [s]", ylabel="contraction [mm]")
    a.legend()
    save(picture, "bladder-friction")


def butyl_slow_rise() -> None:
    print("butyl: as published, five times the friction, elastic bladder")
    picture, (a, b, c) = figure(3)
    fast = simulate("Validation.ButylSlowRise", 10)
    slow = simulate("Validation.ButylSlowRise", 80, **{"inlet.height": 0.17, "inlet.stop": 1e3, "outlet.start": 1e3})
    for i, name in enumerate(("as published", r"$\mu_d$ five times", "elastic bladder, 2 MPa")):
        style = {"color": COLOURS[i], "label": name}
        a.plot(fast.time, fast.values[f"x[{i + 1}]"] * 1e3, **style)
        for axes, r, end, what in ((b, fast, 4.9, "fast"), (c, slow, 80, "slow")):
            filling = r.time < end
            p, x = r.values[f"p[{i + 1}]"][filling] / 1e3, r.values[f"x[{i + 1}]"][filling]
            axes.plot(p, x * 1e3, **style)
            say(f"{what}: last contraction", x[-1] * 1e3, unit="mm")
            say(f"{what}: 10 to 90 %", rise_time(r.time[filling], x), unit="s")
            say(f"{what}: contraction at 50 and 100 kPa", *np.interp([50, 100], p, x * 1e3), unit="mm")
    a.set(xlabel="time [s]", ylabel="contraction [mm]", title="0.35 A")
    b.set(xlabel="gauge pressure [kPa]", ylabel="contraction [mm]", title="filling at 0.35 A")
    c.set(xlabel="gauge pressure [kPa]", ylabel="contraction [mm]", title="filling at 0.17 A")
    c.legend(fontsize=8)
    save(picture, "butyl-slow-rise")


def gas_temperature() -> None:
    print("temperature of the latex muscle, wall as printed")
    r = simulate("Validation.GasTemperature", 10, 4001)
    picture, (a, b, c) = figure(3, 10.5, 3.5)
    cases = (("power", 1, "power law (60), n = 1.2"), ("power", 2, "power law (60), n = 1.4"),
             ("energy", 1, "balance of energy"), ("energy", 2, "the same, $\\mu_{fb}$ = 0.04"))  # fmt: skip
    for (which, i, label), colour in zip(cases, (COLOURS[3], COLOURS[1], COLOURS[0], COLOURS[2]), strict=True):
        p, x, heat = (r.values[f"{name}_{which}[{i}]"] for name in ("p", "x", "T"))
        late = {"ls": "--"} if label.startswith("the same") else {}
        for axes, y in ((a, p / 1e3), (b, x * 1e3), (c, heat - 273.15)):
            axes.plot(r.time, y, color=colour, label=label, lw=1.3, **late)
        say(f"{label}: p and x at 4.9 s", np.interp(4.9, r.time, p) / 1e3, np.interp(4.9, r.time, x) * 1e3)
        course = np.interp([1, 2, 4.9, 5.5, 7], r.time, heat) - 293.15
        say(f"{label}: T - T_atm at 1, 2, 4.9, 5.5, 7 s, highest and lowest", *course, heat.max() - 293.15,
            heat.min() - 293.15, unit="K")  # fmt: skip
        filling = (r.time > 0.3) & (r.time < 4)
        say(f"{label}: highest after the first 0.3 s", heat[filling].max() - 293.15, unit="K")
    later = r.time > 0.15
    slow = r.values["T_slow"] - 273.15
    c.plot(r.time[later], slow[later], "k:", lw=1, label="$T_{atm} + V \\dot p/(h_c A_q)$")
    c.axhline(24, color="0.5", lw=0.8)
    c.text(10, 24.2, "DP: about 4 °C", fontsize=7, ha="right", va="bottom", color="0.3")
    a.set(xlabel="time [s]", ylabel="gauge pressure [kPa]")
    b.set(xlabel="time [s]", ylabel="contraction [mm]")
    c.set(xlabel="time [s]", ylabel="gas temperature [°C]")
    picture.legend(*c.get_legend_handles_labels(), loc="outside upper center", ncols=5, fontsize=8)
    save(picture, "gas-temperature")


def butyl_pressure() -> None:
    print("butyl muscle: three exponents, and the length of the text")
    r = simulate("Validation.ButylPressure", 10)
    picture, (a, b) = figure(2, 8.0)
    for i, n in enumerate((1.0, 1.2, 1.4)):
        p, x = r.values[f"p[{i + 1}]"] / 1e3, r.values[f"x[{i + 1}]"] * 1e3
        a.plot(r.time, p, color=COLOURS[i], label=f"$n_g$ = {n:g}")
        b.plot(r.time, x, color=COLOURS[i], label=f"$n_g$ = {n:g}")
        say(f"n = {n}: p at 1, 4.9, 6 s", *np.interp([1, 4.9, 6], r.time, p), unit="kPa")
        say(f"n = {n}: x at 4.9 s", np.interp(4.9, r.time, x), unit="mm")
    b.plot(r.time, r.values["x_long"] * 1e3, "k--", lw=1, label="$n_g$ = 1.2, 24 cm")
    a.plot(r.time, r.values["p_long"] / 1e3, "k--", lw=1, label="$n_g$ = 1.2, 24 cm")
    say("24 cm: p at 1 s, x at 4.9 s", np.interp(1, r.time, r.values["p_long"]) / 1e3,
        np.interp(4.9, r.time, r.values["x_long"]) * 1e3)  # fmt: skip
    a.set(xlabel="time [s]", ylabel="gauge pressure [kPa]")
    b.set(xlabel="time [s]", ylabel="contraction [mm]")
    b.legend()
    save(picture, "butyl-pressure")


def two_lengths() -> None:
    print("hysteresis of two lengths")
    r = simulate("Validation.TwoLengths", 10, 8001)
    picture, axes = figure(2, 8.0)
    late = r.time > 5
    for i, (length, f) in enumerate(((0.15, 0.2), (0.30, 0.2), (0.15, 2), (0.30, 2))):
        p, eps = r.values[f"p[{i + 1}]"][late] / 1e3, r.values[f"eps[{i + 1}]"][late] * 100
        axes[i // 2].plot(p, eps, color=COLOURS[i % 2], lw=1.2, ls="-" if i % 2 else "--", label=f"{length * 1e3:g} mm")
        middle = np.abs(p - 300) < 3
        say(f"{length} m, {f} Hz: width of the loop at 300 kPa", np.ptp(eps[middle]), unit="% of the length")
    for a, f in zip(axes, (0.2, 2), strict=True):
        a.set(xlabel="gauge pressure [kPa]", ylabel="contraction ratio [%]", title=f"sine of {f:g} Hz")
        a.legend()
    save(picture, "two-lengths")


def tank_curves() -> None:
    print("tank curves")
    picture, axes = figure(2, 9.0)
    r = simulate("Validation.TankCurves", 100, 2001)
    shades = plt.get_cmap("viridis")(np.linspace(0, 0.9, 8))
    volumes = (2.1, 1.85, 1.6, 1.35, 1.1, 0.85, 0.6, 0.35)
    for a, supply in zip(axes, (207, 138), strict=True):
        for i, volume in enumerate(volumes):
            a.plot(r.time, r.values[f"p_{supply}[{i + 1}]"] / 1e3, color=shades[i], label=f"{volume:g} L", lw=1.2)
        a.set(xlabel="time [s]", ylabel="gauge pressure [kPa]", title=f"supply {supply} kPa, n = 1.2")
    axes[1].legend(title="volume", fontsize=7)
    save(picture, "tank-curves")
    for i in (0, 7):
        t, p = r.time[r.time < 40], r.values[f"p_207[{i + 1}]"][r.time < 40]
        say(f"{volumes[i]} L, 207 kPa: 50 %, 90 %", *np.interp([103.5e3, 186.3e3], p, t), unit="s")


def loads_and_rates() -> None:
    print("loops of the empirical muscle: load, frequency, width of the loop")
    r = simulate("Validation.LoadsAndRates", 20, 4001)
    picture, axes = figure(2, 8.0)
    late = r.time > 2
    for i, (m, f) in enumerate(((5, 0.5), (5, 2), (20, 0.5), (20, 2))):
        p, eps = r.values[f"p[{i + 1}]"][late] / 1e3, r.values[f"eps[{i + 1}]"][late] * 100
        axes[i % 2].plot(p, eps, color=COLOURS[i // 2], lw=0.7, label=f"{m} kg")
        middle = np.abs(p - 200) < 5
        say(f"{m} kg, {f} Hz: spread of the contraction at 200 kPa", np.ptp(eps[middle]), unit="% of the length")
    for a, f in zip(axes, (0.5, 2), strict=True):
        a.set(xlabel="gauge pressure [kPa]", ylabel="contraction ratio [%]", title=f"random wave up to {f:g} Hz")
        a.legend()
    save(picture, "loads-and-rates")


def force_dynamics() -> None:
    print("forces of the empirical muscle: 5, 10, 20, 30 kg")
    r = simulate("Validation.ForceDynamics", 20, 4001)
    picture, rows = plt.subplots(2, 4, figsize=(12, 5), layout="constrained", sharey="row")
    names = (("F_net", "$F_{net}$"), ("F_hys", "$F_{hys}$"), ("F_dyn", "$F_{dyn}$"))
    for i, m in enumerate((5, 10, 20, 30)):
        above, below = rows[0, i], rows[1, i]
        late, part = r.time > 2, (r.time > 8) & (r.time < 13)
        eps = r.values[f"eps[{i + 1}]"] * 100
        above.plot(eps[late], r.values[f"F_s[{i + 1}]"][late], color=COLOURS[0], lw=0.8, label="$F_s$")
        above.axhline(m * 9.80665, color="0.4", ls=":", label="$M g$")
        above.set(xlabel="contraction ratio [%]", title=f"{m} kg")
        for colour, (name, label) in zip(COLOURS[1:], names, strict=True):
            below.plot(r.time[part], r.values[f"{name}[{i + 1}]"][part], color=colour, lw=1, label=label)
        below.set(xlabel="time [s]", ylim=(-22, 22))
        say(f"{m} kg: F_dyn above 2 %, at most", np.abs(r.values[f"F_dyn[{i + 1}]"][late & (eps > 2)]).max(), unit="N")
    for a in rows[:, 0]:
        a.set_ylabel("force [N]")
        a.legend(fontsize=8)
    save(picture, "force-dynamics")


def force_grid() -> None:
    print("Kang's force")
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
        here = force(np.array([6e5 - 10, 6e5 + 10, 6e5, 6e5, 6e5]), np.array([0.1, 0.1, 0.1 - 1e-5, 0.1 + 1e-5, 0.1]))
        b.plot(p / 1e5, force(p, np.full_like(p, 0.1)), color=COLOURS[0], label="equation, 10 % strain")
    slope, stiffness = (here[1] - here[0]) / 20, (here[2] - here[3]) / (2e-5 * 0.3)
    b.plot(p / 1e5, here[4] + slope * (p - 6e5), color=COLOURS[1], ls="--", label="its own slope at 6 bar")
    b.plot(p / 1e5, here[4] + 5.7238e-5 * (p - 6e5), color=COLOURS[2], ls=":", label="slope printed in AM Fig. 7")
    say("F, dF/dP, dF/dL at 6 bar, 10 %", here[4], slope, stiffness)
    a.set(xlabel="contraction ratio [%]", ylabel="pull [N]")
    b.set(xlabel="gauge pressure [bar]", ylabel="pull [N]")
    a.legend()
    b.legend()
    save(picture, "force-grid")


def three_element_shape() -> None:
    print("shape of two frustums and a cylinder")
    picture, (a, b) = figure(2, 8.0)
    eps = np.linspace(0, 0.3, 121)
    for i, braid in enumerate(("CylindricalBraid", "ThreeElementShape", "TothovaPitel")):
        package = "Components" if i == 0 else "Laws.Forces"
        source = f"""model Shape{i} extends PneumaticMuscle.Benches.StaticForce(muscle(
          L0=0.24, D0=0.02, alpha_0=0.4823479, redeclare model Braid = PneumaticMuscle.{package}.{braid}));
          end Shape{i};"""
        reach = eps[eps < 0.164] if braid == "ThreeElementShape" else eps  # its assertion ends a run beyond
        force, volume = _shape(f"Shape{i}", source, reach)
        name = ("cylinder", "two frustums, cylinder: DP (13)", "barrel: DP (9)")[i]
        a.plot(100 * reach, force, color=COLOURS[i], label=name)
        b.plot(100 * reach, volume * 1e6, color=COLOURS[i])
        say(name + ": F at 0, 10, 15 %", *np.interp([0, 0.1, 0.15], reach, force), unit="N")
        say(name + ": V at 0, 10, 15 %", *np.interp([0, 0.1, 0.15], reach, volume * 1e6), unit="mL")
    for axes in (a, b):
        axes.axvspan(16.4, 30, color="0.85", zorder=0)
        axes.set(xlabel="contraction ratio [%]")
    b.text(16.8, 62, "DP (13) does not exist here", fontsize=7)
    a.set(ylabel="pull at 200 kPa [N]", ylim=(0, 420))
    b.set(ylabel="volume [mL]")
    a.legend(fontsize=8, loc="upper right")
    save(picture, "shapes")


def _shape(name: str, source: str, eps: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    course = np.arange(eps.size, dtype=float)
    with Simulator(build_source(name, source)) as simulator:
        inputs = Inputs(course, {"p": np.full_like(eps, 2e5), "eps": eps})
        r = simulator.run(course, inputs=inputs, outputs=["F", "muscle.braid.V"])
    return r.values["F"], r.values["muscle.braid.V"]


def lumped_step() -> None:
    print("linear model, 2.5 to 4.5 bar")
    r = simulate("Examples.LumpedStep", 1.5)
    picture, axes = figure(3)
    curves = (("p", "gauge pressure [bar]", 1e-5), ("L", "length [mm]", 1e3), ("F", "change of pull [N]", 1))
    for a, (name, label, factor) in zip(axes, curves, strict=True):
        y = r.values[name] * factor
        a.plot(r.time, y, color=COLOURS[0], label="model")
        for rate, mark, colour in ((10, "o", COLOURS[1]), (80, ".", COLOURS[2])):
            t = np.arange(0, 1.5, 1 / rate)
            a.plot(t, np.interp(t, r.time, y), mark, color=colour, ms=4, label=f"{rate} Hz")
        a.set(xlabel="time [s]", ylabel=label)
    axes[0].legend()
    save(picture, "lumped-step")
    say("largest change of pull, seen at 10 Hz and at 80 Hz", r.values["F"].max(), *(
        np.interp(np.arange(0, 1.5, 1 / rate), r.time, r.values["F"]).max() for rate in (10, 80)
    ), unit="N")  # fmt: skip


def main() -> None:
    PICTURES.mkdir(parents=True, exist_ok=True)
    for draw in (
        tank_curves, polytropic_exponent, gas_temperature, bladder_friction, butyl_pressure, butyl_slow_rise,
        loads_and_rates, force_dynamics, two_lengths, force_grid, three_element_shape, lumped_step,
    ):  # fmt: skip
        draw()


if __name__ == "__main__":
    main()
