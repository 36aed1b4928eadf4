"""The library's benches against another Modelica compiler with its own solver (rumoca)."""

import re
import shutil
from pathlib import Path

import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.resources import modelica_root
from tests.compiler.run import at, simulate
from tests.tiers import quick

rumoca = pytest.importorskip("rumoca")

MODELS = {
    "VesselOrifice": "model Check extends PneumaticMuscle.Benches.VesselOrifice; end Check;",
    "TankFilling": """model Check
  extends PneumaticMuscle.Benches.TankFilling(u_in=0.35, u_out=0, p_supply=207e3);
end Check;""",
    "Isotonic": """model Check
  extends PneumaticMuscle.Benches.Isotonic(u_in=0.35, u_out=0, p_supply=207e3);
end Check;""",
}


def library_that_begins_at_fixed_values(folder: Path) -> Path:
    """A copy of the library whose `fixed` is what it is by default: rumoca evaluates no expression there."""
    shutil.copytree(modelica_root() / "PneumaticMuscle", folder / "PneumaticMuscle")
    for file in folder.rglob("*.mo"):
        text = file.read_text()
        file.write_text(re.sub(r"fixed=dynamics (==|<>) Types\.Dynamics\.\w+", "fixed=true", text))
    return folder


@pytest.mark.parametrize("bench", quick(MODELS, "TankFilling"))
def test_same_curve(bench, tmp_path: Path):
    file = tmp_path / "Check.mo"
    file.write_text(MODELS[bench])
    ode = compile_model(str(file))
    model = rumoca.Session(
        roots=[str(library_that_begins_at_fixed_values(tmp_path / "library"))]
    ).loads(MODELS[bench], model="Check")
    theirs = model.simulate((0, 2.0), config=rumoca.SimConfig(rtol=1e-9, atol=1e-9))
    states = simulate(ode, [2.0])
    ours = at(ode, {name: row[-1] for name, row in states.items()}, t=2.0)
    for name in ode.interface.outputs:
        assert ours[name] == pytest.approx(theirs[name][-1], rel=1e-5)
