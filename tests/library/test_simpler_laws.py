"""What is left of an effect at a bound of a parameter: the same readings as the simpler effect that its class names."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.fmu import read_interface
from tests.library.catalogue import base, built, effects, law_bench, noise, on_bench, run, values

CREEP, LINE = {"k": 300.0}, {"A": 3e-7}
LEFT: dict[tuple[str, str, str], tuple[dict[str, float], dict[str, float]]] = {
    ("MaxwellCreep", "tau", "min"): (CREEP, {"c": 30}),
    ("MaxwellCreep", "tau", "max"): (CREEP, CREEP),
    ("PronyCreep", "k_1", "min"): ({"k_2": 300, "tau": 0.2}, {"k": 300, "tau": 2}),
    ("PronyCreep", "k_2", "min"): ({"k_1": 300, "tau": 2}, {"k": 300, "tau": 2}),
    ("PronyCreep", "tau", "max"): ({"k_1": 200, "k_2": 200}, {"k": 400}),
    ("DahlFriction", "d", "min"): ({"F_c": 10}, {"F_c": 10, "v_s": 1e-6}),
    ("MaxwellSlipFriction", "d", "min"): ({"F_c": 10}, {"F_c": 10, "v_s": 1e-6}),
    ("FlexibleVolume", "V_p", "min"): ({"V_0": 1e-5}, {"V_d": 1e-5}),
    ("SideVolume", "V", "min"): ({}, {}),
    ("ResonantVolume", "V", "min"): ({}, {}),
    ("ResonantVolume", "I", "min"): ({"V": 1e-5, "UA": 0.02}, {"G": 1e-8, "V": 1e-5, "UA": 0.02}),
    ("ConvectiveGas", "h_1", "min"): ({"h_0": 10}, {"h": 10}),
    ("LongLine", "V", "min"): (LINE, LINE),
    ("LongLine", "A", "max"): ({"V": 1e-5}, {"V": 1e-5}),
    ("ThermocoupleSheath", "r", "min"): ({"tau": 1}, {"tau": 1}),
    ("ThermocoupleStem", "stem", "min"): ({"tau": 1}, {"tau": 1}),
    ("ThermocoupleStem", "tau_stem", "min"): ({"tau": 1.5, "stem": 0.5}, {"tau": 1}),
    ("PressureTwoLags", "tau", "min"): ({}, {}),
    ("PressureTwoLags", "r", "min"): ({"tau": 0.05}, {"tau": 0.05}),
    ("OpeningRateLimit", "travel", "min"): ({}, {}),
}  # fmt: skip


def test_every_simpler_law_is_measured() -> None:
    stated = {
        (e.name, parameter, end): left
        for e in effects()
        for parameter, both in e.simpler.items()
        for end, left in zip(("min", "max"), both, strict=True)
        if left is not None and e.absent.keys() != {parameter}
    }
    assert stated.keys() == LEFT.keys()


@pytest.mark.parametrize(("name", "parameter", "end"), LEFT, ids="-".join)
def test_at_its_bound_a_law_is_the_simpler_one(name: str, parameter: str, end: str) -> None:
    effect = next(e for e in effects() if e.name == name)
    left = effect.simpler[parameter][end == "max"]
    bench = law_bench(name)
    own, others = LEFT[name, parameter, end]
    known = read_interface(built(bench, name)).parameters
    full = next(n for n in on_bench(name, bench).parameters[name] if n.endswith(f".{parameter}"))
    bound = getattr(known[full], end)
    assert bound is not None
    shown, interface = run(
        built(bench, name), values(effect, on_bench(name, bench), own | {parameter: bound}), 1e-8
    )
    expected, _ = without, _ = base(bench, 1e-8)
    if left:
        simpler = next(e for e in effects() if e.name == left)
        at = values(simpler, on_bench(left, bench), others)
        expected, _ = run(built(bench, left), at, 1e-8)
    off, size = (
        max(np.sqrt(np.mean((a[n] - b[n]) ** 2)) / noise(interface.outputs[n]) for n in shown)
        for a, b in ((shown, expected), (expected, without))
    )
    assert off < max(0.5, 0.02 * size) and (not left or off < 0.5 * size), (off, size)
