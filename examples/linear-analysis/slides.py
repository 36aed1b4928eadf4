"""The linearisation of the slides: coefficients about 6 bar and 10 %, the step from 2.5 to 4.5 bar, two lengths.

python examples/linear-analysis/slides.py [FOLDER FOR PICTURES]
"""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import pam_cosim as pam

HERE = Path(__file__).parent
PRINTED = {"C_1": 5.7238e-5, "C_2": 8061.8}  # AM Fig. 7
LENGTH = 0.3  # m
BLUE, RED, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#6b7178"


def coefficients(p: str, eps: str = "10 %") -> tuple[float, float, float]:
    """Pull [N], and its slopes by gauge pressure [m2] and by length [N/m]."""
    linear = pam.linearise("StaticForce", at={"p": p, "eps": eps})
    by_pressure, by_strain = linear.D[0]
    return linear.point.outputs["F"], by_pressure, -by_strain / LENGTH


def pulls(bars: np.ndarray, strains: np.ndarray) -> np.ndarray:
    """The force equation itself [N]: each sample of the inputs is a point."""
    course = np.arange(bars.size, dtype=float)
    run = pam.simulate(
        "StaticForce",
        inputs=pam.Inputs(course, {"p": bars * 1e5, "eps": strains / 100}),
        interval=1.0,
    )
    return run["F"]


def about_a_point(folder: Path) -> None:
    """What the stated parameters give, and how far a straight line carries."""
    pull, c_1, c_2 = coefficients("6 bar")
    print(f"about 6 bar and 10 %: F = {pull:.2f} N, C_1 = {c_1:.4e} m2, C_2 = {c_2:.1f} N/m")
    print(f"  the slides print    C_1 = {PRINTED['C_1']:.4e} m2, C_2 = {PRINTED['C_2']:.1f} N/m")
    low, high = coefficients("2.5 bar")[0], coefficients("4.5 bar")[0]
    middle = coefficients("3.5 bar")
    print(f"about 3.5 bar and 10 %: C_1 = {middle[1]:.4e} m2, C_2 = {middle[2]:.1f} N/m")
    print(f"from 2.5 to 4.5 bar at 10 % the pull rises by {high - low:.1f} N;")
    print(f"  by the slope about 6 bar {2e5 * c_1:.1f} N, ", end="")
    print(f"about 3.5 bar {2e5 * middle[1]:.1f} N, as printed {2e5 * PRINTED['C_1']:.1f} N")

    figure, (by_pressure, by_length) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    bars, strains = np.linspace(1, 8, 29), np.linspace(2, 18, 33)
    by_pressure.plot(
        bars, pulls(bars, np.full(bars.size, 10.0)), color=BLUE, label="force equation"
    )
    by_pressure.plot(
        bars, pull + c_1 * (bars - 6) * 1e5, "--", color=RED, label="its slope about 6 bar"
    )
    by_pressure.plot(
        bars, pull + PRINTED["C_1"] * (bars - 6) * 1e5, ":", color=GREEN, label="slope as printed"
    )
    by_pressure.axvspan(2.5, 4.5, color="#e4e7ea", zorder=0)
    by_pressure.set(xlabel="gauge pressure [bar], at 10 %; grey: the step", ylabel="pull [N]")
    by_length.plot(
        strains, pulls(np.full(strains.size, 6.0), strains), color=BLUE, label="force equation"
    )
    line = pull - c_2 * LENGTH * (strains - 10) / 100
    by_length.plot(strains, line, "--", color=RED, label="its slope, as printed")
    by_length.set(xlabel="contraction [%], at 6 bar", ylabel="pull [N]")
    save(figure, (by_pressure, by_length), folder / "slides-linearisation.png")


def step(folder: Path) -> None:
    """The linear model of AM Fig. 9 from 2.5 to 4.5 bar, with the coefficients of three points."""
    times = np.linspace(0, 1.2, 1201)
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    points = (
        ("about 6 bar", coefficients("6 bar"), RED),
        ("about 3.5 bar", coefficients("3.5 bar"), BLUE),
    )
    for name, (_, c_1, c_2), colour in (*points, ("as printed", (0.0, *PRINTED.values()), GREEN)):
        linear = pam.linearise("LumpedLinear", {"C_1": c_1, "C_2": c_2})
        answer = linear.step(times)[:, :, 0] * 2e5
        force = answer[:, linear.outputs.index("F")]
        swing = linear.modes[-1]
        print(
            f"step with C_1, C_2 {name}: {swing.frequency:.2f} Hz, damping ratio {swing.damping:.3f}; ",
            end="",
        )
        seen = [force[:: round(1000 / rate)].max() for rate in (10, 80)]
        print(
            f"pull up to {force.max():.1f} N ({seen[0]:.1f} at 10 Hz, {seen[1]:.1f} at 80 Hz, ",
            end="",
        )
        print("if the step falls on a sample), ", end="")
        print(f"then {force[-1]:.1f} N")
        axes[0].plot(times, 1e3 * answer[:, linear.outputs.index("L")], color=colour, label=name)
        axes[1].plot(times, force, color=colour, label=name)
        if name == "about 3.5 bar":
            axes[1].plot(
                times[::100], force[::100], "o", color=colour, mfc="none", label="at 10 Hz"
            )
    axes[0].set(xlabel="time [s]", ylabel="change of length [mm]")
    axes[1].set(xlabel="time [s]", ylabel="change of pull [N]")
    save(figure, axes, folder / "slides-step.png")


def loop_width(time: np.ndarray, p: np.ndarray, eps: np.ndarray) -> float:
    """Largest less smallest strain at the moments after 5 s at which the pressure passes 3 bar."""
    before = np.flatnonzero(((p[:-1] < 3e5) != (p[1:] < 3e5)) & (time[:-1] > 5))
    share = (3e5 - p[before]) / (p[before + 1] - p[before])
    return float(np.ptp(eps[before] + share * (eps[before + 1] - eps[before])))


def two_lengths(folder: Path) -> None:
    """Loops of muscles of two lengths, and why a linear model does not have them."""
    muscles = range(1, 5)
    watched = [f"bench[{i}].regulator.p" for i in muscles]
    run = pam.simulate("Examples.Validation.TwoLengths", outputs=watched, interval="0.5 ms")
    widths = [
        loop_width(run.time, run[p], 100 * run[f"eps[{i}]"])
        for p, i in zip(watched, muscles, strict=True)
    ]
    print("the loop, where the muscle's pressure passes 3 bar, is ", end="")
    print(
        "{:.2f} % of the length wide at 0.2 Hz for 150 and {:.2f} % for 300 mm, ".format(
            *widths[:2]
        ),
        end="",
    )
    print("{:.2f} and {:.2f} % at 2 Hz".format(*widths[2:]))
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    frequencies = np.geomspace(0.1, 20, 9)
    for length, marker in ((0.15, "o"), (0.30, "s")):
        for size, colour in (("2 bar", BLUE), ("0.1 bar", RED)):
            response = pam.frequency_response(
                str(HERE / "SlidesMuscle.mo"), {"p": "3 bar", "muscle.L0": length}, input="p", outputs=["eps"],
                amplitude=size, frequencies=frequencies,
            )  # fmt: skip
            gain, linear = response.gain[:, 0] * 1e7, response.linear_gain[:, 0] * 1e7  # % per bar
            name = f"{length * 1e3:.0f} mm, {size}"
            left.loglog(frequencies, np.abs(gain), color=colour, marker=marker, ms=4, label=name)
            right.semilogx(
                frequencies,
                np.degrees(np.angle(gain)),
                color=colour,
                marker=marker,
                ms=4,
                label=name,
            )
            print(
                f"{name}: {np.abs(gain[0]):.2f} % per bar at 0.1 Hz (linear model {np.abs(linear[0]):.2f}), ",
                end="",
            )
            print(
                f"{np.angle(gain[0], deg=True):.0f}° ({np.angle(linear[0], deg=True):.0f}°), ",
                end="",
            )
            print(f"distortion {response.distortion[0, 0]:.1%}")
        name = f"{length * 1e3:.0f} mm, linear"
        left.loglog(
            frequencies, np.abs(linear), color=GREY, marker=marker, ms=3, ls=":", label=name
        )
        right.semilogx(
            frequencies, np.degrees(np.angle(linear)), color=GREY, marker=marker, ms=3, ls=":"
        )
    left.set(xlabel="frequency [Hz]", ylabel="contraction [% per bar]")
    right.set(xlabel="frequency [Hz]", ylabel="phase [°]")
    save(figure, (left,), folder / "slides-two-lengths.png")


def save(figure: plt.Figure, legends: tuple, path: Path) -> None:
    """Writes a picture."""
    for axes in figure.axes:
        axes.grid(color="#e4e7ea")
    for axes in legends:
        axes.legend(frameon=False, fontsize=8)
    figure.savefig(path, dpi=110)
    print(f"written: {path}")


if __name__ == "__main__":
    target = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    target.mkdir(parents=True, exist_ok=True)
    plt.switch_backend("Agg")
    about_a_point(target)
    step(target)
    two_lengths(target)
