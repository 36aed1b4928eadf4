"""The empirical muscle of Dzahir and Yamamoto: loops and forces under a random wave."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from pam_cosim.fmu import build_source
from pam_cosim.simulation import Inputs, Simulator
from scripts.validation.drawing import COLOURS, figure, numbers, save, simulate, widths

EMPIRICAL = """model EmpiricalForce
  extends PneumaticMuscle.Benches.StaticForce(muscle(L0=0.3, D0=0.02, alpha_0=23*PneumaticMuscle.Constants.pi/180,
    redeclare model Braid = PneumaticMuscle.Laws.Forces.Empirical));
end EmpiricalForce;"""  # the measures of Muscles.Components.EmpiricalMuscle
PRESSURES = (100, 200, 300, 400)  # kPa, at which the static force is drawn


def loads_and_rates(folder: Path) -> list[str]:
    """DY Figs. 2, 7 and 8."""
    cases = ((5, 0.5), (5, 2), (20, 0.5), (20, 2))
    r = simulate("Examples.Validation.LoadsAndRates", 20, 4001)
    picture, axes = figure(2, 8.0)
    late = r.time > 2
    for i, (m, _) in enumerate(cases):
        p, eps = r.values[f"p[{i + 1}]"][late] / 1e3, r.values[f"eps[{i + 1}]"][late] * 100
        axes[i % 2].plot(p, eps, color=COLOURS[i // 2], lw=0.7, label=f"{m} kg")
    for a, f in zip(axes, (0.5, 2), strict=True):
        a.set(
            xlabel="gauge pressure [kPa]",
            ylabel="contraction ratio [%]",
            title=f"random wave up to {f:g} Hz",
        )
        a.legend()
    save(picture, folder, "loads-and-rates")
    a, b, c, d = widths("Examples.Validation.LoadsAndRates", 20, 20001, 2e5, 2.0)
    return [
        f"{a:.2f} and {b:.2f} % of the length (5 kg, 0.5 and 2 Hz), {c:.2f} and {d:.2f} % (20 kg)"
    ]


def force_dynamics(folder: Path) -> list[str]:
    """DY Fig. 5: forces by contraction and by input pressure, at four loads."""
    r = simulate("Examples.Validation.ForceDynamics", 20, 4001)
    picture, rows = plt.subplots(2, 4, figsize=(12, 5.4), layout="constrained", sharey="row")
    names = (("F_net", "$F_{net}$"), ("F_hys", "$F_{hys}$"), ("F_dyn", "$F_{dyn}$"))
    strain = np.linspace(0, 0.3, 61)
    curves = _static_force(strain)
    late, largest = r.time > 2, []
    for i, m in enumerate((5, 10, 20, 30)):
        above, below = rows[0, i], rows[1, i]
        eps, p = r.values[f"eps[{i + 1}]"] * 100, r.values[f"p[{i + 1}]"] / 1e3
        for pressure, force in zip(PRESSURES, curves, strict=True):
            above.plot(100 * strain, force, color="0.6", lw=0.7)
            above.annotate(f"{pressure}", (0.3, force[0]), fontsize=6, color="0.4", va="bottom")
        above.plot(
            eps[late], r.values[f"F_s[{i + 1}]"][late], color=COLOURS[0], lw=0.8, label="$F_s$"
        )
        above.axhline(m * 9.80665, color="0.4", ls=":", label="$M g$")
        above.set(
            xlabel="contraction ratio [%]",
            title=f"{m} kg",
            ylim=(0, 1.05 * curves[-1][0]),
            xlim=(0, 20),
        )
        for colour, (name, label) in zip(COLOURS[1:], names, strict=True):
            below.plot(
                p[late], r.values[f"{name}[{i + 1}]"][late], color=colour, lw=0.6, label=label
            )
        below.set(xlabel="input pressure [kPa]", ylim=(-22, 22))
        largest.append(np.abs(r.values[f"F_dyn[{i + 1}]"][late & (eps > 2)]).max())
    for a in rows[:, 0]:
        a.set_ylabel("force [N]")
        a.legend(fontsize=8, loc="upper right")
    save(picture, folder, "force-dynamics")
    lost = max(
        float(np.abs(r.values[f"F_net[{i}]"] - r.values[f"F_elastic[{i}]"] - r.values[f"F_hys[{i}]"]
                     - r.values[f"F_dyn[{i}]"]).max()) for i in (1, 2, 3, 4)
    )  # fmt: skip
    return [
        *["F_dyn balances F_net, F_elastic and F_hys to 1e-6 N"] * (lost < 1e-6),
        f"above 2 % contraction at most {numbers(largest, 1)} N for 5, 10, 20 and 30 kg",
    ]


def _static_force(strain: np.ndarray) -> list[np.ndarray]:
    """Static force [N] of the muscle of these runs by contraction ratio, at each of the pressures."""
    curves = []
    with Simulator(build_source("EmpiricalForce", EMPIRICAL)) as simulator:
        for pressure in PRESSURES:
            course = np.arange(strain.size, dtype=float)
            inputs = Inputs(course, {"p": np.full_like(strain, pressure * 1e3), "eps": strain})
            curves.append(simulator.run(course, inputs=inputs).values["F"])
    return curves
