"""Models that OpenModelica flattens and this compiler solves, where ``omc`` is on the path."""

from __future__ import annotations

from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim.cli.app import main
from pam_cosim.compiler.openmodelica import flat_model
from pam_cosim.errors import ModelError
from tests.openmodelica.compiler import OMC, WHY_NOT

VESSELS = """package Vessels "Vessels whose gas carries its enthalpy in a stream"
  connector Port
    Real p(unit="Pa");
    flow Real m_flow(unit="kg/s");
    stream Real h(unit="J/kg");
  end Port;
  model Vessel
    Port port;
    parameter Real V(unit="m3") = 1e-3;
    parameter Real T_start(unit="K") = 400;
    Real m(unit="kg");
    Real p(unit="Pa", start=3e5, fixed=true);
    Real T(unit="K", start=T_start, fixed=true);
  equation
    m*287*T = p*V;
    der(m) = port.m_flow;
    der(m*718*T) = port.m_flow*actualStream(port.h);
    port.h = 1005*T;
    port.p = p;
  end Vessel;
  model Resistance
    Port a;
    Port b;
    parameter Real k(min=1e-9, max=1e-6) = 1e-8;
  equation
    a.m_flow = k*(a.p - b.p);
    a.m_flow + b.m_flow = 0;
    a.h = inStream(b.h);
    b.h = inStream(a.h);
  end Resistance;
  model Two
    Vessel one;
    Vessel two(T_start=300, p(start=1e5));
    Resistance r;
    output Real p(unit="Pa") = two.p;
    output Real T(unit="K") = two.T;
    output Real T_other(unit="K") = one.T;
  equation
    connect(one.port, r.a);
    connect(r.b, two.port);
    annotation (experiment(StopTime=2, Interval=0.02));
  end Two;
  model Wrong
    Real x = nothing_of_this_name;
  end Wrong;
end Vessels;
"""


@pytest.fixture
def vessels(tmp_path: Path) -> Path:
    """The file of that package."""
    file = tmp_path / "Vessels.mo"
    file.write_text(VESSELS)
    return file


@pytest.mark.skipif(OMC is None, reason=WHY_NOT)
@pytest.mark.parametrize("bench", ["Isotonic", pytest.param("TankFilling", marks=pytest.mark.full)])
def test_both_front_ends_make_the_same_model(bench: str) -> None:
    own, flat = (pam.describe(model) for model in (bench, _flat(bench)))
    assert own.inputs == flat.inputs and own.outputs == flat.outputs
    assert {n: v.start for n, v in own.parameters.items()}.items() <= {
        n: v.start for n, v in flat.parameters.items()
    }.items()
    one, other = pam.simulate(bench), pam.simulate(_flat(bench))
    for name in own.outputs:
        assert other[name] == pytest.approx(one[name], rel=1e-6, abs=1e-9 * abs(one[name]).max())


def _flat(bench: str) -> str:
    return str(flat_model(f"PneumaticMuscle.Benches.{bench}"))


@pytest.mark.skipif(OMC is None, reason=WHY_NOT)
def test_streams_are_simulated_and_fitted(
    vessels: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    by = ["--file", str(vessels), "--compiler", "omc"]
    csv, data = tmp_path / "run.csv", tmp_path / "data"
    data.mkdir()
    assert main(["simulate", "Vessels.Two", "--set", "r.k=2e-8", *by, "-o", str(csv)]) == 0
    end = csv.read_text().split()[-1].split(",")
    assert float(end[1]) == pytest.approx(2e5, rel=1e-3)  # the energy of both is what it was
    (data / "run.csv").write_text(csv.read_text())
    (data / "experiment.toml").write_text(
        'model = "Vessels.Two"\n[signals.p]\nsigma = "100 Pa"\n[signals.T]\nsigma = "0.1 K"\n'
        '[fit]\n"r.k" = { min = 1e-9, max = 1e-6 }\n[[runs]]\nfile = "run.csv"\nrole = "fit"\n'
    )
    capsys.readouterr()
    assert main(["fit", str(data), *by]) == 0
    assert "r.k = 2e-08" in capsys.readouterr().out
    assert main(["compare", str(data), "--file", str(vessels)]) == 2
    assert "stream connectors are not supported" in capsys.readouterr().err


@pytest.mark.skipif(OMC is None, reason=WHY_NOT)
def test_what_openmodelica_refuses_is_refused_at_its_place(vessels: Path) -> None:
    with pytest.raises(ModelError, match="nothing_of_this_name not found") as refused:
        flat_model("Vessels.Wrong", [vessels])
    line = VESSELS[: VESSELS.index("nothing_of_this_name")].count("\n") + 1
    assert (refused.value.file, refused.value.line) == (str(vessels), line)


def test_where_it_is_not_installed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", "")
    assert main(["describe", "Isotonic", "--compiler", "omc"]) == 2
    assert "leave --compiler out" in capsys.readouterr().err
    assert main(["describe", "Isotonic"]) == 0
    assert main(["describe", "Isotonic", "--compiler", "gcc"]) == 2
    assert "write own or omc" in capsys.readouterr().err
    assert main(["describe", "Isotonic", "--compiler", "own"]) == 0
