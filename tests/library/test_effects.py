"""Every effect of the library, whichever it is: what it declares, that it runs, vanishes and shows."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import casadi as ca
import numpy as np
import pytest

from pam_cosim.catalogue import EffectClass
from pam_cosim.compiler import Ode
from pam_cosim.fmu import read_interface
from pam_cosim.model.interface import Interface
from tests.library.catalogue import (
    base,
    benches,
    built,
    compiled,
    composed,
    effects,
    homes,
    law_bench,
    noise,
    on_bench,
    run,
    tree,
    values,
    without_numbers,
)

BALANCES = {
    "elasticity": "force", "dry_friction": "force", "rate_friction": "force", "creep": "force", "end_shape": "force",
    "moving_mass": "force", "valve_dynamics": "mass", "valve_area": "mass", "supply_line": "mass",
    "dead_volume": "mass", "leak": "mass", "gas_energy": "energy", "wall_heat": "energy", "friction_heat": "energy",
    "thermocouple_lag": "sensor", "pressure_offset": "sensor", "position_sensor": "sensor", "force_sensor": "sensor",
    "pressure_sensor_lag": "sensor", "temperature_sensor": "sensor", "clock_offset": "sensor", "saturation": "sensor",
}  # fmt: skip

FINE = 1e-9  # tolerance of the solver
AT_ONCE = 2  # samples
OTHER_LAWS = ("VerticalLoad", "StaticForce")
"""Benches whose muscle has not the laws of Doumit and Pardoel, so that an effect takes the place of something else."""

every_effect = pytest.mark.parametrize("effect", effects(), ids=lambda e: e.name)


def test_every_family_has_an_effect_and_none_is_unknown() -> None:
    assert {e.family: e.balance for e in effects()} == BALANCES


@every_effect
def test_declaration_is_complete(effect: EffectClass) -> None:
    own = {c.name: c for c in tree().components(effect.qualified_name)}
    for word in ("Source:", "Fingerprint:"):
        assert word in effect.documentation, f"{effect.name} does not state its {word}"
    assert "typical" in effect.documentation.lower(), (
        f"{effect.name} does not state what is typical"
    )
    assert effect.description and effect.parameters
    for name in effect.parameters:
        assert own[name].description
    assert set(effect.absent) <= set(effect.parameters) >= set(effect.typical)


@every_effect
def test_finds_a_place(effect: EffectClass) -> None:
    assert any(composed(bench, effect.name) for bench in benches())


@every_effect
def test_parameters_have_units_and_start_inside_their_bounds(effect: EffectClass) -> None:
    interface = read_interface(built(law_bench(effect.name), effect.name))
    composition = on_bench(effect.name)
    assert len(composition.typical) == len(effect.typical)
    for name in composition.parameters[effect.name]:
        v = interface.parameters[name]
        assert v.unit and v.description, name
        low, high = composition.typical.get(name, (v.min, v.max))
        assert v.min <= low <= v.start <= high <= v.max, name
        assert v.min is not None and v.max is not None and v.start is not None, name
        assert v.min <= v.start <= v.max and v.min < v.max, name
        assert v.nominal is None or v.nominal > 0, name


@every_effect
def test_runs_within_its_bounds(effect: EffectClass) -> None:
    assert without_numbers(effect.name, law_bench(effect.name), _ends) == []


@pytest.mark.full
@every_effect
def test_runs_within_its_bounds_on_other_benches(effect: EffectClass) -> None:
    for bench in homes(effect.name):
        assert without_numbers(effect.name, bench, _ends) == [], bench


def _ends(interface: Interface, names: Sequence[str]) -> Iterator[dict[str, float]]:
    """Each parameter at its least and at its largest value, the others as stated."""
    for name in names:
        v = interface.parameters[name]
        for value in (v.min, v.max):
            assert value is not None
            yield {name: value}


@every_effect
def test_shows_in_a_measurement(effect: EffectClass) -> None:
    """On the bench of its law, or else on some other: a thermometer's effect needs one that is read."""
    every = sorted(benches(), key=lambda bench: bench != law_bench(effect.name))
    assert any(_change(effect, bench) > 1 for bench in every if composed(bench, effect.name))


def _change(effect: EffectClass, bench: str) -> float:
    """The largest change of an output, in what an instrument can show."""
    outputs, interface = run(built(bench, effect.name), {})
    without, _ = base(bench)
    return max(
        float(np.abs(y - without[n]).max()) / noise(interface.outputs[n])
        for n, y in outputs.items()
    )


@every_effect
def test_vanishes_at_its_stated_values(effect: EffectClass) -> None:
    if not effect.absent:
        said = " ".join(effect.documentation.split())
        assert re.search("[Nn]o (value|set of values)[^.]* gives the base law back", said), (
            "does not say when it is absent"
        )
        return
    _vanish(effect, law_bench(effect.name))


@pytest.mark.full
@every_effect
def test_vanishes_at_its_stated_values_on_other_benches(effect: EffectClass) -> None:
    for bench, composition in homes(effect.name).items():
        if effect.absent and not (bench.endswith(OTHER_LAWS) and "redeclare" in composition.text):
            _vanish(effect, bench)


def _vanish(effect: EffectClass, bench: str) -> None:
    """Where the base model pulls, for a cylinder without bladder may push; a lag is one while all begins at once."""
    own = effect.absent
    exactly = set(own.values()) <= {0.0, 1.0}
    share, first = (1e-3, 0) if exactly else (1.0, AT_ONCE)  # exactly, or in the limit
    outputs, interface = run(
        built(bench, effect.name), values(effect, on_bench(effect.name, bench), own), FINE
    )
    without, _ = base(bench, FINE)
    for name, y in outputs.items():
        known = interface.outputs[name]
        pushes = (without[name] < noise(known)) & (known.quantity == "Force")
        off = np.abs(y - without[name])[~pushes][first:]
        assert off.max(initial=0.0) <= share * noise(known), (bench, name)


@every_effect
def test_derivatives_are_finite_at_rest_and_at_the_bounds(effect: EffectClass) -> None:
    composition, ode = on_bench(effect.name), compiled(law_bench(effect.name), effect.name)
    assert ode is not None
    variables = ode.interface.parameters
    rates = ca.Function("rates", [ode.t, ode.x, ode.u, ode.d, ode.p], [ode.derivatives])
    slopes = rates.jacobian()
    initial = ca.Function("initial", [ode.p, ode.u], [ode.initial])
    inputs = [
        [v.start or 0.0 for v in ode.interface.inputs.values()],
        [0.0] * len(ode.interface.inputs),
    ]
    for name in composition.parameters[effect.name]:
        v = variables[name]
        for value in (v.min, v.start, v.max):
            p = [value if n == name else other.start for n, other in variables.items()]
            at_start = initial(p, inputs[0]).full().ravel()
            for x, u in ((x, u) for x in (at_start, _at_corners(ode, at_start)) for u in inputs):
                d = [1.0 if delay.input is None else u[delay.input] for delay in ode.delays]
                jacobians = slopes(0, x, u, d, p, rates(0, x, u, d, p))
                parts = jacobians if isinstance(jacobians, tuple) else (jacobians,)
                assert all(np.isfinite(part.full()).all() for part in parts), (name, value)


def _at_corners(ode: Ode, x: np.ndarray) -> np.ndarray:
    """The same state with every length, speed and share at zero, where laws have their corners."""
    return np.where([state.unit in ("m", "m/s", "1") for state in ode.states], 0.0, x)
