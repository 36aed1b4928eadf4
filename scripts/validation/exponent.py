"""The chain of Doumit and Pardoel: tanks, the polytropic exponent, and what its power law does to the mass of gas."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Simulator
from scripts.validation.drawing import COLOURS, P_ATM, T_ATM, R, at, figure, numbers, save, simulate

EXPONENTS = (1.0, 1.2, 1.4)
VOLUMES = (2.1, 1.85, 1.6, 1.35, 1.1, 0.85, 0.6, 0.35)  # L
ENERGY = """model EnergyIsotonic
  extends PneumaticMuscle.Benches.Isotonic(muscle(redeclare model Gas = PneumaticMuscle.Effects.GasEnergy.EnergyGas));
end EnergyIsotonic;"""


def tank_curves(folder: Path) -> list[str]:
    """DP section 4.4, Figs. 4 and 5."""
    picture, axes = figure(2, 9.0)
    r = simulate("Examples.Validation.TankCurves", 100, 2001)
    shades = plt.get_cmap("viridis")(np.linspace(0, 0.9, 8))
    for a, supply in zip(axes, (207, 138), strict=True):
        for i, volume in enumerate(VOLUMES):
            a.plot(
                r.time,
                r.values[f"p_{supply}[{i + 1}]"] / 1e3,
                color=shades[i],
                label=f"{volume:g} L",
                lw=1.2,
            )
        a.set(
            xlabel="time [s]", ylabel="gauge pressure [kPa]", title=f"supply {supply} kPa, n = 1.2"
        )
    axes[1].legend(title="volume", fontsize=7)
    save(picture, folder, "tank-curves")
    told = []
    for i in (0, 7):
        t, p = r.time[r.time < 40], r.values[f"p_207[{i + 1}]"][r.time < 40]
        half, most = np.interp([103.5e3, 186.3e3], p, t)
        told.append(f"{VOLUMES[i]:g} L reach 50 % at {half:.2f} s and 90 % at {most:.2f} s")
    return [f"On 207 kPa {told[0]}, {told[1]}."]


def polytropic_exponent(folder: Path) -> list[str]:
    """DP Figs. 8, 10 and 12."""
    r = simulate("Examples.Validation.PolytropicExponent", 10)
    picture, (a, b, c) = figure(3)
    for i, n in enumerate(EXPONENTS):
        key, style = f"[{i + 1}]", {"color": COLOURS[i], "label": f"$n_g$ = {n:g}"}
        a.plot(r.time, r.values["p" + key] / 1e3, **style)
        a.plot(r.time, r.values["p_printed" + key] / 1e3, color=COLOURS[i], ls="--", lw=1)
        b.plot(r.time, r.values["x" + key] * 1e3, **style)
        b.plot(r.time, r.values["x_printed" + key] * 1e3, color=COLOURS[i], ls="--", lw=1)
        c.plot(r.time, r.values["T" + key] - 273.15, **style)
    a.set(
        xlabel="time [s]",
        ylabel="gauge pressure [kPa]",
        title="solid: films of air\ndashed: DP (45) as printed",
    )
    b.set(xlabel="time [s]", ylabel="contraction [mm]")
    c.set(xlabel="time [s]", ylabel="gas temperature [°C]", title="films of air")
    a.legend()
    save(picture, folder, "polytropic-exponent")
    sharp = simulate(
        "Examples.Validation.PolytropicExponent", 10, **{"inlet.rise": 1e-4, "outlet.rise": 1e-4}
    )
    first, vented, switched = (
        [at(run, f"p[{i}]", t) / 1e3 for i in (1, 2, 3)]
        for run, t in ((r, 1.0), (r, 6.0), (sharp, 6.0))
    )
    steady = [at(r, f"x[{i}]", 4.9) * 1e3 for i in (1, 2, 3)]
    p, x = ([at(r, f"{name}_printed[{i}]", 4.9) for i in (1, 2, 3)] for name in ("p", "x"))
    return [
        f"the steady contraction is {numbers(steady, 1)} mm; the transients differ little: {numbers(first, 1)} kPa at "
        f"1 s, {numbers(vented, 1)} kPa at 6 s.",
        f"switched within a millisecond it is {numbers(switched, 1)} kPa.",
        f"n = 1 fills to {p[0] / 1e3:.0f} kPa and {x[0] * 1e3:.1f} mm, 1.2 stalls at {p[1] / 1e3:.1f} kPa and "
        f"{x[1] * 1e3:.1f} mm, 1.4 at {p[2] / 1e3:.1f} kPa and {x[2] * 1e3:.1f} mm.",
    ]


def phantom_flow(folder: Path) -> list[str]:
    """What a full muscle goes on drawing from its supply, by the power law and by the balance of energy."""
    del folder
    times = np.linspace(0, 300, 60001)
    polytropic = _mass(build_model("Isotonic"), times)
    energy = _mass(build_source("EnergyIsotonic", ENERGY), times)
    missing = [100 * float(np.interp(t, times, polytropic["missing"])) for t in (3, 5, 10, 60)]
    flow = polytropic["flow"][-1] * 1e6
    later = [float(np.interp(t, times, energy["flow"])) * 1e6 for t in (60, 300)]
    heat = 1.4 * R / 0.4 * T_ATM * polytropic["flow"][-1]
    return [
        f"{missing[0]:.1f} % of the mass that flowed in are missing after 3 s, {missing[1]:.1f} % after 5 s, "
        f"{missing[2]:.0f} % after 10 s and {missing[3]:.0f} % after a minute",
        f"draws {flow:.2f} mg/s from its supply for ever, whose enthalpy, {heat:.2f} W, is just the heat",
        f"the flow dies away ({later[0]:.2f} mg/s after one minute, {_at_most(abs(later[1]))} after five)",
        f"{_at_most(100 * np.abs(energy['missing'][200:]).max())} % of the mass are missing",
    ]


def _at_most(value: float) -> str:
    return "less than 0.001" if value < 1e-3 else f"{value:.3f}"


def _mass(fmu: Path, times: np.ndarray) -> dict[str, np.ndarray]:
    """Flow into a muscle that fills from 207 kPa at 0.35 A, and the share of it that p V/(R T) does not show."""
    outputs = ["p", "T", "muscle.gas.V", "valve.inlet.m_flow"]
    with Simulator(fmu) as simulator:
        values = simulator.run(
            times, parameters={"p_supply": 207e3, "u_in": 0.35}, outputs=outputs
        ).values
    mass = (values["p"] + P_ATM) * values["muscle.gas.V"] / (R * values["T"])
    flow = values["valve.inlet.m_flow"]
    into = np.concatenate([[0.0], np.cumsum((flow[1:] + flow[:-1]) / 2 * np.diff(times))])
    return {"flow": flow, "missing": 1 - (mass - mass[0]) / np.maximum(into, 1e-12)}
