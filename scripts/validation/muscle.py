"""The muscles of Doumit and Pardoel: friction of the bladder, the butyl muscle, the temperature of the gas."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Simulator, Trajectory
from scripts.validation.drawing import COLOURS, P_ATM, T_ATM, at, figure, numbers, save, simulate

POWER, ENERGY = "T_power[1]", "T_energy[1]"
SUPPLIES = (60, 90, 120, 160, 207, 250, 300)  # kPa
CURRENTS = (0.2, 0.25, 0.3, 0.35)  # A
MOVES = 5e-3  # m, contraction beyond which the first air has been compressed


def rise_time(t: np.ndarray, x: np.ndarray) -> float:
    """From 10 % to 90 % of the last value [s]; x must rise."""
    reached = np.maximum.accumulate(x / x[-1])
    return float(np.interp(0.9, reached, t) - np.interp(0.1, reached, t))


def bladder_friction(folder: Path) -> list[str]:
    """DP Figs. 9 and 11."""
    r = simulate("Examples.Validation.BladderFriction", 10)
    picture, (a,) = figure(1, 4.6)
    for i, mu in enumerate((0.015, 0.04)):
        a.plot(
            r.time, r.values[f"x[{i + 1}]"] * 1e3, color=COLOURS[i], label=rf"$\mu_{{fb}}$ = {mu:g}"
        )
    a.set(xlabel="time [s]", ylabel="contraction [mm]")
    a.legend()
    save(picture, folder, "bladder-friction")
    low, high = (at(r, f"x[{i}]", 4.9) * 1e3 for i in (1, 2))
    return [f"lowers the steady contraction of the butyl muscle from {low:.1f} to {high:.1f} mm"]


def butyl_pressure(folder: Path) -> list[str]:
    """DP Fig. 7."""
    r = simulate("Examples.Validation.ButylPressure", 10)
    picture, (a, b) = figure(2, 8.0)
    for i, n in enumerate((1.0, 1.2, 1.4)):
        p, x = r.values[f"p[{i + 1}]"] / 1e3, r.values[f"x[{i + 1}]"] * 1e3
        a.plot(r.time, p, color=COLOURS[i], label=f"$n_g$ = {n:g}")
        b.plot(r.time, x, color=COLOURS[i], label=f"$n_g$ = {n:g}")
    b.plot(r.time, r.values["x_long"] * 1e3, "k--", lw=1, label="$n_g$ = 1.2, 24 cm")
    a.plot(r.time, r.values["p_long"] / 1e3, "k--", lw=1, label="$n_g$ = 1.2, 24 cm")
    a.set(xlabel="time [s]", ylabel="gauge pressure [kPa]")
    b.set(xlabel="time [s]", ylabel="contraction [mm]")
    b.legend()
    save(picture, folder, "butyl-pressure")
    early, late = ([at(r, f"p[{i}]", t) / 1e3 for i in (1, 2, 3)] for t in (1, 6))
    steady = {f"{at(r, f'x[{i}]', 4.9) * 1e3:.1f}" for i in (1, 2)}
    return [
        f"{numbers(early, 1)} kPa at 1 s for n = 1, 1.2 and 1.4; {numbers(late, 1)} kPa at 6 s; "
        f"{steady.pop()} mm in all",
        f"it has {at(r, 'p_long', 1) / 1e3:.1f} kPa at 1 s and contracts by {at(r, 'x_long', 4.9) * 1e3:.1f} mm",
    ]


def butyl_slow_rise(folder: Path) -> list[str]:
    """DP Fig. 9: as published, five times the friction, an elastic bladder."""
    picture, (a, b, c) = figure(3)
    model = "Examples.Validation.ButylSlowRise"
    fast = simulate(model, 10)
    slow = simulate(model, 80, **{"inlet.height": 0.17, "inlet.stop": 1e3, "outlet.start": 1e3})
    rise: dict[str, list[float]] = {"fast": [], "slow": []}
    at_100: dict[str, list[float]] = {"fast": [], "slow": []}
    last: list[float] = []
    for i, name in enumerate(("as published", r"$\mu_d$ five times", "elastic bladder, 2 MPa")):
        style = {"color": COLOURS[i], "label": name}
        a.plot(fast.time, fast.values[f"x[{i + 1}]"] * 1e3, **style)
        for axes, r, end, what in ((b, fast, 4.9, "fast"), (c, slow, 80, "slow")):
            filling = r.time < end
            p, x = r.values[f"p[{i + 1}]"][filling] / 1e3, r.values[f"x[{i + 1}]"][filling]
            axes.plot(p, x * 1e3, **style)
            rise[what].append(rise_time(r.time[filling], x))
            at_100[what].append(float(np.interp(100, p, x * 1e3)))
            if what == "fast":
                last.append(x[-1] * 1e3)
    a.set(xlabel="time [s]", ylabel="contraction [mm]", title="0.35 A")
    b.set(xlabel="gauge pressure [kPa]", ylabel="contraction [mm]", title="filling at 0.35 A")
    c.set(xlabel="gauge pressure [kPa]", ylabel="contraction [mm]", title="filling at 0.17 A")
    c.legend(fontsize=8)
    save(picture, folder, "butyl-slow-rise")
    return [
        f"does lengthen the rise from {rise['fast'][0]:.2f} to {rise['fast'][1]:.2f} s at 0.35 A",
        f"it leaves the steady contraction as it was ({last[1]:.1f} mm)",
        f"at 0.17 A the contraction at 100 kPa is {at_100['slow'][1]:.1f} mm against {at_100['slow'][0]:.1f} mm",
        f"makes the rise {rise['fast'][2]:.2f} s at 0.35 A and {rise['slow'][2]:.1f} instead of {rise['slow'][0]:.1f} "
        f"s at 0.17 A, and lowers the steady contraction to {last[2]:.1f} mm",
    ]


def gas_temperature(folder: Path) -> list[str]:
    """DP (45), (60) and Fig. 12."""
    r = simulate("Examples.Validation.GasTemperature", 10, 4001)
    picture, (a, b, c) = figure(3, 10.5, 3.5)
    cases = (("power", 1, "power law (60), n = 1.2"), ("power", 2, "power law (60), n = 1.4"),
             ("energy", 1, "balance of energy"), ("energy", 2, "the same, $\\mu_{fb}$ = 0.04"))  # fmt: skip
    for (which, i, label), colour in zip(
        cases, (COLOURS[3], COLOURS[1], COLOURS[0], COLOURS[2]), strict=True
    ):
        p, x, heat = (r.values[f"{name}_{which}[{i}]"] for name in ("p", "x", "T"))
        late = {"ls": "--"} if label.startswith("the same") else {}
        for axes, y in ((a, p / 1e3), (b, x * 1e3), (c, heat - 273.15)):
            axes.plot(r.time, y, color=colour, label=label, lw=1.3, **late)
    later = r.time > 0.15
    slow = r.values["T_slow"] - 273.15
    c.plot(r.time[later], slow[later], "k:", lw=1, label="$T_{atm} + V \\dot p/(h_c A_q)$")
    c.axhline(24, color="0.5", lw=0.8)
    c.text(10, 24.2, "DP: about 4 °C", fontsize=7, ha="right", va="bottom", color="0.3")
    a.set(xlabel="time [s]", ylabel="gauge pressure [kPa]")
    b.set(xlabel="time [s]", ylabel="contraction [mm]")
    c.set(xlabel="time [s]", ylabel="gas temperature [°C]")
    picture.legend(*c.get_legend_handles_labels(), loc="outside upper center", ncols=5, fontsize=8)
    save(picture, folder, "gas-temperature")
    return _told_of_temperature(r)


def _told_of_temperature(r: Trajectory) -> list[str]:
    filling = (r.time > 0.3) & (r.time < 4)
    warm, rubbed = (r.values[f"T_energy[{i}]"] - T_ATM for i in (1, 2))
    law = [T_ATM * ((1 + 207e3 / P_ATM) ** ((n - 1) / n) - 1) for n in (1.2, 1.4)]
    stalled = r.values[POWER].max() - T_ATM
    return [
        f"heats the gas by {law[0]:.0f} K for n = 1.2 and by {law[1]:.0f} K for 1.4 at 207 kPa, and by {stalled:.0f} K "
        "in the stalled muscle.",
        f"fill the muscle: {at(r, 'p_energy[1]', 4.9) / 1e3:.1f} kPa and {at(r, 'x_energy[1]', 4.9) * 1e3:.2f} mm. "
        f"The gas warms by {at(r, ENERGY, 2) - T_ATM:.1f} K (at 2 s; {warm.max():.1f} K for a moment as the first air "
        f"is compressed, {warm[filling].max():.1f} K at most after that), is back at ambient when the muscle is full, "
        f"and cools by {-warm.min():.1f} K in venting",
        f"takes {1e3 * (at(r, 'x_energy[1]', 4.9) - at(r, 'x_energy[2]', 4.9)):.1f} mm off the contraction and at most "
        f"{np.abs(warm - rubbed)[filling].max():.1f} K off the temperature from 0.3 to 4 s",
    ]


def temperature_band(folder: Path) -> list[str]:
    """DP Fig. 12 by the supply and the current, which DP print for their tanks alone."""
    times = np.linspace(0, 20, 8001)
    highest, lasting = (
        np.zeros((len(CURRENTS), len(SUPPLIES))),
        np.zeros((len(CURRENTS), len(SUPPLIES))),
    )
    with Simulator(build_model("PneumaticMuscle.Examples.PrintedWallEnergyGas")) as simulator:
        for i, current in enumerate(CURRENTS):
            for j, supply in enumerate(SUPPLIES):
                given = {"u_in": current, "p_supply": supply * 1e3}
                r = simulator.run(times, parameters=given, outputs=["T", "x"]).values
                rise, moves = r["T"] - T_ATM, r["x"] > MOVES
                highest[i, j], lasting[i, j] = rise.max(), rise[moves].max()
    picture, (a,) = figure(1, 5.6, 3.4)
    a.fill_between(
        SUPPLIES, lasting.min(axis=0), lasting.max(axis=0), color=COLOURS[0], alpha=0.2, lw=0
    )
    for current, row, style in zip(CURRENTS, lasting, (":", "--", "-.", "-"), strict=True):
        a.plot(
            SUPPLIES,
            row,
            color=COLOURS[0],
            ls=style,
            lw=1.2,
            label=f"balance of energy, {current:g} A",
        )
    p = np.linspace(SUPPLIES[0], SUPPLIES[-1], 100)
    for n, colour in ((1.2, COLOURS[3]), (1.4, COLOURS[1])):
        a.plot(p, celsius_law(p, n), color=colour, label=f"power law of degrees Celsius, n = {n:g}")
    a.axhline(4, color="0.5", lw=0.8)
    a.text(300, 4.1, "DP: about 4 °C", fontsize=7, ha="right", color="0.3")
    a.set(
        xlabel="gauge pressure of the supply [kPa]",
        ylabel="rise of temperature [K]",
        ylim=(0, None),
    )
    a.legend(fontsize=7)
    save(picture, folder, "temperature-band")
    return [
        f"from {lasting.min():.1f} to {lasting.max():.1f} K over supplies of {SUPPLIES[0]} to {SUPPLIES[-1]} kPa and "
        f"currents of {CURRENTS[0]} to {CURRENTS[-1]} A once the muscle moves (from {highest.min():.1f} to "
        f"{highest.max():.1f} K while the first air is compressed)",
        f"with degrees Celsius in the place of kelvins gives {celsius_law(90, 1.4):.1f} K for n = 1.4 at 90 kPa, "
        f"{celsius_law(207, 1.4):.1f} K at 207 kPa, and no rise for n = 1",
    ]


def celsius_law(p: np.ndarray | float, n: float) -> np.ndarray:
    """Rise [K] by (60) as a power law, 20 °C put in as the number 20; ``p`` gauge [kPa]."""
    return np.asarray(20 * ((1 + np.asarray(p) * 1e3 / P_ATM) ** ((n - 1) / n) - 1))
