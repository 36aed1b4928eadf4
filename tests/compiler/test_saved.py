"""A compiled model that was written and read again is the same model: C source and description are, byte by byte."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim.compiler import (
    Ode,
    compile_model,
    ode_bytes,
    read_ode,
    smooth_parameters,
    with_sensitivities,
)
from pam_cosim.fmu import odes
from pam_cosim.fmu.build import fmu_bytes
from pam_cosim.fmu.generate import model_source
from pam_cosim.fmu.odes import cached_ode, write_archives
from tests.fmu.models import delayed_mix
from tests.fmu.test_tape import warning_lag
from tests.library.catalogue import on_bench

GUID = "{00000000-0000-0000-0000-000000000000}"


def alike(one: Ode, other: Ode) -> bool:
    same = [
        getattr(one, n) == getattr(other, n)
        for n in ("interface", "states", "description", "parts", "libraries")
    ]
    return all(same) and model_source(one, GUID) == model_source(other, GUID)


@pytest.mark.parametrize("make", [delayed_mix, warning_lag], ids=["delays", "statements"])
def test_what_a_model_may_have(make: Callable[[], Ode]) -> None:
    ode = make()
    assert alike(ode, read_ode(ode_bytes(ode)))


@pytest.mark.parametrize("effect", ["GeneralDryFriction", "ValveDelay", "WarmWall"])
def test_an_effect_on_its_bench(effect: str, tmp_path: Path) -> None:
    composition = on_bench(effect)
    file = tmp_path / f"{composition.name}.mo"
    file.write_text(composition.text)
    ode = compile_model(str(file))
    read = read_ode(ode_bytes(ode))
    assert alike(ode, read)
    own = [name for name in composition.parameters[effect] if name in smooth_parameters(ode)]
    assert alike(with_sensitivities(ode, own), with_sensitivities(read, own))
    assert fmu_bytes(ode, []) == fmu_bytes(read, [])


def test_it_is_made_once_or_comes_with_the_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ode, calls = warning_lag(), []

    def make() -> Ode:
        calls.append(1)
        return ode

    monkeypatch.setenv("PAM_COSIM_CACHE", str(tmp_path / "cache"))
    assert alike(cached_ode("a" * 64, make), ode) and alike(cached_ode("a" * 64, make), ode)
    assert len(calls) == 1
    write_archives(
        tmp_path / "shipped",
        {"some.xz": {"b" * 64: ode_bytes(ode), "c" * 64: ode_bytes(delayed_mix())}},
    )
    monkeypatch.setattr("pam_cosim.fmu.odes.shipped_models", lambda: tmp_path / "shipped")
    odes._index.cache_clear()
    assert alike(cached_ode("b" * 64, make), ode) and alike(
        cached_ode("c" * 64, make), delayed_mix()
    )
    assert len(calls) == 1
    cached_ode("d" * 64, make)
    assert len(calls) == 2
    odes._index.cache_clear()
