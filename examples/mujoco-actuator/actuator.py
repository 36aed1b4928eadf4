"""A muscle as an actuator of MuJoCo, with its error against the model: a scene in which it lifts a mass.

python examples/mujoco-actuator/actuator.py [MODEL] -o muscle.xml

A general actuator with affine gain and bias (MuJoCo 3, "MJCF reference, actuator/general") exerts the force
``(g0 + g1 l) u + b0 + b1 l``: u the control, here the gauge pressure, and l the length of a tendon. The four
coefficients are fitted by linear least squares to the pull of the model at rest, where the muscle pulls.
"""

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import pam_cosim as pam
from pam_cosim.fitting import read_parameters

Array = NDArray[np.float64]
GRID = 25  # points along pressure and along contraction
LEAST = 8  # points at which the muscle pulls: twice the number of coefficients
SLACK = 1e-3  # N: the rounding errors of a slack muscle are smaller


@dataclass(frozen=True)
class Actuator:
    """The four coefficients of a muscle, and their error against the model.

    Attributes:
        model: its name.
        coefficients: g0 [N/Pa], g1 [N/(Pa.m)], b0 [N], b1 [N/m]; a negative force pulls.
        length: of the muscle without contraction [m].
        pressures: lowest and highest gauge pressure [Pa]. contractions: smallest and largest [m].
        greatest: pull of the model [N].
        rms: difference from the model where the muscle pulls [N]. worst: the largest difference there [N].
        points: number of points of the fit.
    """

    model: str
    coefficients: Array
    length: float
    pressures: tuple[float, float]
    contractions: tuple[float, float]
    greatest: float
    rms: float
    worst: float
    points: int

    def __str__(self) -> str:
        p, x = 1e-3 * np.array(self.pressures), 1e3 * np.array(self.contractions)
        return (
            f"{self.model} as an actuator of MuJoCo, p {p[0]:g} kPa to {p[1]:g} kPa, "
            f"contraction {x[0]:g} mm to {x[1]:g} mm\n"
            f"  error of the pull: {self.rms:.3g} N rms, {self.rms / self.greatest:.1%} of the greatest pull of "
            f"{self.greatest:.3g} N; {self.worst:.3g} N at most, at {self.points} points at rest\n"
            "  not included: friction and damping, the inertia of the muscle, filling and venting; it never pushes"
        )

    def pull(self, pressure: Array | float, contraction: Array | float) -> Array:
        """The pull [N] at gauge pressures [Pa] and contractions [m]."""
        g0, g1, b0, b1 = self.coefficients
        length = self.length - contraction
        return np.maximum(-((g0 + g1 * length) * pressure + b0 + b1 * length), 0.0)

    def xml(self, time_constant: float | None = None) -> str:
        """A scene of MJCF: the muscle as a tendon that lifts a mass.

        Args:
            time_constant: of the pressure after a step of the control [s]; None: the pressure is the control.
        """
        numbers = [f"{number:.9g}" for number in self.coefficients]
        lag = f'dyntype="filterexact" dynprm="{time_constant:.9g}"' if time_constant else ""
        return f"""\
<mujoco model="muscle">
  <!-- {str(self).replace("--", "- -")} -->
  <!-- copy <tendon> and <actuator>; control: gauge pressure in Pa -->
  <option timestep="0.001" integrator="implicitfast" />
  <worldbody>
    <site name="fixed" pos="0 0 {2 * self.length:.9g}" />
    <body name="load" pos="0 0 {self.length:.9g}">
      <joint name="lift" type="slide" axis="0 0 1" damping="20" limited="true" range="0 {self.contractions[1]:.9g}" />
      <geom type="sphere" size="0.02" mass="1" />
      <site name="moving" />
    </body>
  </worldbody>
  <tendon>
    <spatial name="muscle">
      <site site="fixed" />
      <site site="moving" />
    </spatial>
  </tendon>
  <actuator>
    <general name="muscle" tendon="muscle" gaintype="affine" biastype="affine"
      gainprm="{numbers[0]} {numbers[1]} 0" biasprm="{numbers[2]} {numbers[3]} 0"
      ctrllimited="true" ctrlrange="{self.pressures[0]:.9g} {self.pressures[1]:.9g}"
      forcelimited="true" forcerange="{-1.5 * self.greatest:.9g} 0" {lag} />
  </actuator>
</mujoco>
"""


def actuator(
    model: str = "QuasiStaticIsometric",
    parameters: dict[str, float | str] | None = None,
    *,
    pressure: str = "p=0 kPa:300 kPa",
    contraction: str = "x=0 mm:50 mm",
    force: str = "F",
    length: str = "muscle.L0",
    files: list[Path] | None = None,
) -> Actuator:
    """Fits the coefficients to the pull at rest of a model.

    Args:
        model: one with a pull as output, a pressure and a contraction as inputs.
        parameters: as in ``pam.simulate``.
        pressure: name and range of the input. contraction: name and range of the input.
        force: name of the output.
        length: name of the parameter that is the length without contraction.
        files: further Modelica files.
    """
    interface = pam.describe(model, files or [])
    (p_name, p_values), (x_name, x_values) = map(grid, (pressure, contraction))
    for name, variables, unit in (
        (p_name, interface.inputs, "Pa"),
        (x_name, interface.inputs, "m"),
        (force, interface.outputs, "N"),
        (length, interface.parameters, "m"),
    ):
        if name not in variables or variables[name].unit != unit:
            others = ", ".join(n for n, v in variables.items() if v.unit == unit) or "none"
            raise pam.InputError(f"{model} has no '{name}' in {unit} here; it has {others}")
    points = {p_name: p_values, x_name: x_values}
    scalars = {"pull": f"steady({force})"}
    swept = pam.sweep(model, points, parameters=parameters, scalars=scalars, files=files or [])
    p, x = swept.design.points.T
    whole = swept.fixed.get(length, interface.parameters[length].start)
    if x.max() >= whole:
        raise pam.InputError(f"{x_name} reaches {x.max():g} m, but {length} is {whole:g} m")
    if swept.failed:
        raise pam.SimulationFailure(next(iter(swept.failed.values())))
    return fitted(model, p, x, swept.column("pull"), whole)


def fitted(model: str, p: Array, x: Array, pull: Array, length: float) -> Actuator:
    """Linear least squares over the points at which the muscle pulls."""
    pulls = pull > SLACK
    if pulls.sum() < LEAST:
        raise pam.InputError(
            f"{model} pulls at {pulls.sum()} of {len(p)} points: choose another range"
        )
    along = (length - x)[pulls]
    table = np.column_stack([p[pulls], p[pulls] * along, np.ones_like(along), along])
    scale = np.abs(table).max(axis=0)
    best = np.linalg.lstsq(table / scale, -pull[pulls], rcond=None)[0] / scale
    error = np.maximum(-(table @ best), 0.0) - pull[pulls]
    return Actuator(
        model,
        best,
        length,
        (p.min(), p.max()),
        (x.min(), x.max()),
        pull.max(),
        np.sqrt(np.mean(error**2)),
        np.abs(error).max(),
        int(pulls.sum()),
    )


def pair(text: str) -> tuple[str, str]:
    """The name and the value of NAME=VALUE."""
    name, equals, value = (part.strip() for part in text.partition("="))
    if not equals:
        raise pam.InputError(f"'{text}': write NAME=VALUE")
    return name, value


def grid(text: str) -> tuple[str, str]:
    """The name of NAME=FROM:TO, and the range with the number of points of ``pam.sweep``."""
    name, ends = pair(text)
    if ends.count(":") != 1:
        raise pam.InputError(f"'{text}': write NAME=FROM:TO, such as 'p=0 kPa:300 kPa'")
    return name, f"{ends}:{GRID}"


def muscle(
    data: str | None, params: Path | None, model: str, files: list[Path]
) -> dict[str, float]:
    """Parameters of the model [SI]: the values that a data set states, and the values of a fit in their place."""
    stated = pam.read(data, files=files).parameters if data else {}
    found = read_parameters(params) if params else {}
    parameters = pam.describe(model, files).parameters
    of_the_model = {name: value for name, value in stated.items() if name in parameters}
    return of_the_model | {n: v for n, v in found.items() if "@" not in n and "/" not in n}


def main(arguments: list[str] | None = None) -> None:
    """Fits the actuator that the command line describes, and writes its scene."""
    parser = argparse.ArgumentParser(description="Make a muscle an actuator of MuJoCo.")
    parser.add_argument("model", nargs="?", default="QuasiStaticIsometric")
    parser.add_argument("--pressure", default="p=0 kPa:300 kPa", help="input and range")
    parser.add_argument("--contraction", default="x=0 mm:50 mm", help="input and range")
    parser.add_argument("--force", default="F", help="output: the pull")
    parser.add_argument("--length", default="muscle.L0", help="parameter: without contraction")
    parser.add_argument("--params", type=Path, help="fitted parameters, of 'pam-cosim fit -o'")
    parser.add_argument("--data", help="data set of the fit: the values that it states")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE")
    parser.add_argument("--time-constant", type=float, help="of the pressure [s]")
    parser.add_argument("--file", action="append", default=[], type=Path, help="Modelica file")
    parser.add_argument("-o", "--output", type=Path, help="MuJoCo scene (.xml)")
    given = parser.parse_args(arguments)
    try:
        values = muscle(given.data, given.params, given.model, given.file)
        made = actuator(
            given.model,
            values | dict(map(pair, given.set)),
            pressure=given.pressure,
            contraction=given.contraction,
            force=given.force,
            length=given.length,
            files=given.file,
        )
    except (pam.InputError, pam.SimulationFailure) as problem:
        sys.exit(f"actuator.py: {problem}")
    print(made)
    if given.output:
        given.output.write_text(made.xml(given.time_constant), encoding="utf-8")
        print(f"written: {given.output}")


if __name__ == "__main__":
    main()
