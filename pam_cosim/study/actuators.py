"""A muscle as an actuator of MuJoCo: its pull at rest over pressure and length, by the law that MuJoCo has for it.

A general actuator with affine gain and bias (MuJoCo 3, "MJCF reference, actuator/general") pushes with
``(g0 + g1 l) u + b0 + b1 l``: u the control, here the gauge pressure, and l the length of a tendon. The four
numbers are fitted to the model's equilibria by linear least squares, where the muscle pulls.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.files import check_ending, write_text
from pam_cosim.model.settings import Setting, resolve, value_of
from pam_cosim.simulation.models import Paths, describe, opened
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, did_you_mean

GRID = 25  # points along pressure and along contraction
_LEAST = 8  # points that pull: twice the numbers that are fitted


@dataclass(frozen=True)
class Actuator(Printed):
    """A muscle by four numbers, and how far they are from the model.

    Attributes:
        model: that it stands for.
        gain: g0 [N/Pa] and g1 [N/(Pa.m)] of the length; negative: it pulls. bias: b0 [N] and b1 [N/m] likewise.
        length: of the muscle at no contraction [m].
        pressures: lowest and highest gauge pressure [Pa]. contractions: smallest and largest [m].
        greatest: pull of the model within them [N].
        rms: root mean square difference from the model where it pulls [N].
        worst: the largest difference there [N].
        points: of the model that it was fitted to.
    """

    model: str
    gain: tuple[float, float]
    bias: tuple[float, float]
    length: float
    pressures: tuple[float, float]
    contractions: tuple[float, float]
    greatest: float
    rms: float
    worst: float
    points: int

    def __str__(self) -> str:
        p, x = (
            " to ".join(format_quantity(one, unit) for one in span)
            for span, unit in ((self.pressures, "Pa"), (self.contractions, "m"))
        )
        rms, worst, most = (
            format_quantity(one, "N") for one in (self.rms, self.worst, self.greatest)
        )
        return (
            f"{self.model} as an actuator of MuJoCo, p {p}, contraction {x}\n"
            f"  its pull is off by {rms} rms, {100 * self.rms / self.greatest:.1f} % of the greatest pull of {most}; "
            f"{worst} at most, at {self.points} points at rest\n"
            "  not in it: friction and damping, the inertia of the muscle, filling and venting; it never pushes"
        )

    def pull(self, pressure: Array, contraction: Array) -> Array:
        """Its pull [N] at gauge pressures [Pa] and contractions [m]; a muscle does not push."""
        along = self.length - contraction
        force = (
            (self.gain[0] + self.gain[1] * along) * pressure + self.bias[0] + self.bias[1] * along
        )
        return np.maximum(-force, 0.0)

    def xml(self, time_constant: float | None = None) -> str:
        """A scene of MJCF that loads: the muscle as a tendon that lifts a mass.

        Args:
            time_constant: [s] in which the pressure follows the control; None: at once.
        """
        root = ElementTree.Element("mujoco", model="muscle")
        root.append(ElementTree.Comment(f" {str(self).replace('--', '- -')} "))
        root.append(
            ElementTree.Comment(
                " take along <tendon> and <actuator>; control: gauge pressure in Pa "
            )
        )
        ElementTree.SubElement(root, "option", timestep="0.001", integrator="implicitfast")
        world = ElementTree.SubElement(root, "worldbody")
        ElementTree.SubElement(world, "site", name="fixed", pos=f"0 0 {2 * self.length:.9g}")
        body = ElementTree.SubElement(world, "body", name="load", pos=f"0 0 {self.length:.9g}")
        ElementTree.SubElement(
            body,
            "joint",
            name="lift",
            type="slide",
            axis="0 0 1",
            damping="20",
            limited="true",
            range=f"0 {self.contractions[1]:.9g}",
        )
        ElementTree.SubElement(body, "geom", type="sphere", size="0.02", mass="1")
        ElementTree.SubElement(body, "site", name="moving")
        tendon = ElementTree.SubElement(
            ElementTree.SubElement(root, "tendon"), "spatial", name="muscle"
        )
        for site in ("fixed", "moving"):
            ElementTree.SubElement(tendon, "site", site=site)
        follows = (
            {}
            if time_constant is None
            else {"dyntype": "filterexact", "dynprm": f"{time_constant:.9g}"}
        )
        ElementTree.SubElement(
            ElementTree.SubElement(root, "actuator"),
            "general",
            {
                "name": "muscle",
                "tendon": "muscle",
                "gaintype": "affine",
                "biastype": "affine",
                "gainprm": " ".join(f"{one:.9g}" for one in (*self.gain, 0.0)),
                "biasprm": " ".join(f"{one:.9g}" for one in (*self.bias, 0.0)),
                "ctrllimited": "true",
                "ctrlrange": " ".join(f"{one:.9g}" for one in self.pressures),
                "forcelimited": "true",
                "forcerange": f"{-1.5 * self.greatest:.9g} 0",
                **follows,
            },
        )
        ElementTree.indent(root)
        return ElementTree.tostring(root, encoding="unicode") + "\n"

    def write(self, path: Path | str, time_constant: float | None = None) -> Path:
        """Writes ``xml`` to a file; whole or not at all.

        Raises:
            InputError: it cannot be written, or its name ends otherwise than in ``.xml``.
        """
        check_ending(Path(path), "an actuator is written as XML", (".xml",))
        write_text(Path(path), self.xml(time_constant))
        return Path(path)


def actuator(
    model: str = "QuasiStaticIsometric",
    parameters: Mapping[str, Setting] | None = None,
    *,
    pressures: tuple[Setting, Setting] = ("0 kPa", "300 kPa"),
    contractions: tuple[Setting, Setting],
    length: str = "muscle.L0",
    names: tuple[str, str, str] = ("p", "x", "F"),
    files: Paths = (),
) -> Actuator:
    """A muscle as an actuator of MuJoCo, with its error against the model.

    ```python
    pam.actuator(parameters={"muscle.L0": "296 mm"}, contractions=("0 mm", "60 mm")).write("muscle.xml")
    ```

    Args:
        model: one that shows a pull under an imposed pressure, at an imposed contraction.
        parameters: values, as in ``simulate``; of an identified muscle its fitted ones.
        pressures: lowest and highest gauge pressure. contractions: smallest and largest.
        length: the parameter that is the length at no contraction.
        names: of the pressure, the contraction and the pull in the model.
        files: further Modelica files.

    Raises:
        InputError: unknown names; spans that are none; a muscle that pulls at too few points.
        SimulationFailure: there is no equilibrium.
    """
    interface = describe(model, files)
    inputs, outputs = interface.inputs, interface.outputs
    for name, known, what, unit in zip(
        (*names, length),
        (inputs, inputs, outputs, interface.parameters),
        ("pressure", "contraction", "force", "length"),
        ("Pa", "m", "N", "m"),
        strict=True,
    ):
        if name not in known:
            raise InputError(
                f"{model} has no '{name}' for an actuator; {did_you_mean(name, list(known))}"
            )
        if known[name].unit != unit:
            raise InputError(f"'{name}' is no {what}: its unit is {known[name].unit}")
    values = resolve(parameters or {}, interface)
    spans = [
        (value_of(low, interface.inputs[name]), value_of(high, interface.inputs[name]))
        for name, (low, high) in zip(names[:2], (pressures, contractions), strict=True)
    ]
    if any(not low < high for low, high in spans):
        raise InputError("a span of pressures or contractions must begin below its end")
    rest = values.get(length, interface.parameters[length].start)
    if rest is None:
        raise InputError(f"{model} has no value of '{length}': state one")
    if spans[1][1] >= rest:
        contracted, whole = (format_quantity(one, "m") for one in (spans[1][1], rest))
        raise InputError(f"a contraction of {contracted} is not within {length}, {whole}")
    p, x = (
        one.ravel() for one in np.meshgrid(*(np.linspace(low, high, GRID) for low, high in spans))
    )
    with opened(model, files) as simulator:
        course = simulator.equilibria({names[0]: p, names[1]: x}, parameters=values)
    return _fitted(model, p, x, course[names[2]], float(rest))


def _fitted(model: str, p: Array, x: Array, force: Array, rest: float) -> Actuator:
    """The four numbers by least squares, over the points at which the muscle pulls."""
    pulls = force > 0.0
    if pulls.sum() < _LEAST:
        raise InputError(f"{model} pulls at {pulls.sum()} of {len(p)} points; choose another span")
    along = (rest - x)[pulls]
    table = np.column_stack([p[pulls], p[pulls] * along, np.ones_like(along), along])
    scale = np.abs(table).max(axis=0)
    found = np.linalg.lstsq(table / scale, -force[pulls], rcond=None)[0] / scale
    g0, g1, b0, b1 = (float(one) for one in found)
    error = np.maximum(-(table @ found), 0.0) - force[pulls]
    return Actuator(
        model,
        (g0, g1),
        (b0, b1),
        rest,
        (float(p.min()), float(p.max())),
        (float(x.min()), float(x.max())),
        float(force.max()),
        float(np.sqrt(np.mean(error**2))),
        float(np.abs(error).max()),
        int(pulls.sum()),
    )
