"""Every class of the library: described, documented, in its package's order; every model builds and runs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.catalogue.place import is_connector
from pam_cosim.compiler import compile_model
from pam_cosim.compiler.class_info import ClassInfo
from pam_cosim.errors import ModelError
from pam_cosim.fmu import build_model
from pam_cosim.resources import modelica_root
from pam_cosim.simulation import Simulator
from tests.library.catalogue import check_each, tree

LIBRARY = modelica_root() / "PneumaticMuscle"
SHELVES = ("Benches", "Examples")


def _public(info: ClassInfo) -> bool:
    """Not a replaceable class inside a model: those are places, not classes of their own."""
    owner = info.name.rpartition(".")[0]
    return not owner or tree().classes[owner].kind == "package"


CLASSES = [info for info in tree().classes.values() if _public(info)]
MODELS = [
    info.name
    for info in CLASSES
    if info.kind == "model" and not info.partial and info.name.split(".")[1] in SHELVES
]  # fmt: skip


def test_every_class_is_described_and_documented() -> None:
    assert len(CLASSES) > 400
    check_each(_is_described, (info.name for info in CLASSES))


def _is_described(name: str) -> None:
    info = tree().classes[name]
    assert info.description and not info.description.endswith("."), info.description
    if info.kind != "type":  # a type's description says all
        assert (
            "<p>" in info.documentation
            or "<ol>" in info.documentation
            or "<ul>" in info.documentation
        ), "documentation"
    for component in info.components:
        assert component.description, component.name


def test_order_names_what_is_there() -> None:
    check_each(_has_order, (str(file.parent) for file in sorted(LIBRARY.rglob("package.mo"))))


def _has_order(folder: str) -> None:
    package = Path(folder)
    there = {f.stem for f in package.glob("*.mo")} - {"package"} | {
        d.name for d in package.iterdir() if d.is_dir()
    }
    order = package / "package.order"
    named = order.read_text().split() if order.exists() else []
    assert sorted(named) == sorted(there) and len(set(named)) == len(named), named


def test_source_says_where_it_belongs() -> None:
    for file in sorted(LIBRARY.rglob("*.mo")):
        parents = file.relative_to(LIBRARY.parent).parts[: -2 if file.name == "package.mo" else -1]
        first = file.read_text().split("\n", 1)[0]
        assert not parents or first == f"within {'.'.join(parents)};", file


@pytest.mark.parametrize("model", MODELS)
def test_model_builds_and_runs(model: str) -> None:
    with Simulator(build_model(model, brief=True)) as simulator:
        interface = simulator.interface
        assert interface.outputs
        run = simulator.run(np.linspace(0, interface.stop_time, 201), max_seconds=20).values
        for name in interface.outputs:
            assert np.isfinite(run[name]).all(), name
        assert any(run[name].any() for name in interface.outputs)


@pytest.mark.parametrize("model", MODELS)
def test_bench_shows_only_inputs_outputs_and_parameters(model: str) -> None:
    assert not [c.name for c in tree().components(model) if is_connector(tree(), c.type)]


def test_law_that_must_be_chosen_refuses_with_what_to_do(tmp_path: Path) -> None:
    file = tmp_path / "Open.mo"
    file.write_text("model Open extends PneumaticMuscle.Examples.ReviewedBench; end Open;")
    with pytest.raises(
        ModelError, match="redeclare model Force = PneumaticMuscle.Laws.Forces.Gaylord"
    ):
        compile_model(str(file))


def test_piece_of_a_coupled_system_is_translated_alone() -> None:
    interface = compile_model("PneumaticMuscle.CoSimulation.RatedGas").interface
    assert {name: interface.parameters[name].start for name in ("n", "h_film")} == {
        "n": 1.2,
        "h_film": 20,
    }
