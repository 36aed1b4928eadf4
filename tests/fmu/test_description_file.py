"""A description is read as FMPy reads it; what refers to nothing is refused."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import fmpy
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from pam_cosim.fmu.description_file import ModelDescription, parse
from pam_cosim.fmu.read import read_description
from tests.fmu import models
from tests.simulation.test_foreign_types import valve_fmu

TYPE = ("unit", "displayUnit", "quantity", "min", "max", "nominal")
VARIABLE = ("name", "valueReference", "type", "description", "causality", "variability", *TYPE)
TIMES = ("startTime", "stopTime", "tolerance", "stepSize")
FLAGS = {  # by the names of FMPy
    "canGetAndSetFMUState": "canGetAndSetFMUstate",
    "canSerializeFMUState": "canSerializeFMUstate",
    "canHandleVariableCommunicationStepSize": "canHandleVariableCommunicationStepSize",
    "canInterpolateInputs": "canInterpolateInputs",
    "needsCompletedIntegratorStep": "needsCompletedIntegratorStep",
}
ARRAYS = """<fmiModelDescription fmiVersion="3.0" modelName="M" instantiationToken="t">
<ModelExchange modelIdentifier="m" needsCompletedIntegratorStep="true"/>
<TypeDefinitions><Float64Type name="Length" unit="m" min="0"/>
<EnumerationType name="Mode"><Item name="slow" value="1"/><Item name="fast" value="4"/></EnumerationType>
</TypeDefinitions>
<ModelVariables>
<UInt64 name="n" valueReference="1" causality="structuralParameter" variability="fixed" start="3"/>
<Float64 name="x" valueReference="2" declaredType="Length" start="1 2 3" initial="exact">
<Dimension valueReference="1"/><Dimension start="1"/><Alias name="y" displayUnit="mm"/></Float64>
<Float64 name="v" valueReference="3" derivative="2"><Dimension valueReference="1"/><Dimension start="1"/></Float64>
<Enumeration name="mode" valueReference="4" causality="parameter" declaredType="Mode" start="1"/>
<String name="s" valueReference="5" causality="parameter"><Start value="none"/></String>
<Boolean name="on" valueReference="6" causality="input" start="true"/>
<Float64 name="z" valueReference="7"/>
</ModelVariables>
<ModelStructure><Output valueReference="2" dependencies="6 4"/><Output valueReference="4" dependencies=""/>
<ContinuousStateDerivative valueReference="3"/><EventIndicator valueReference="7"/></ModelStructure>
</fmiModelDescription>"""


def _values(thing: Any, names: tuple[str, ...]) -> list[Any]:
    return [getattr(thing, name) for name in names]


def _assert_same(own: ModelDescription, theirs: Any) -> None:
    names = ("fmiVersion", "modelName", "guid", "generationTool")
    names += ("numberOfEventIndicators", "numberOfContinuousStates")
    assert _values(own, names) == _values(theirs, names)
    if own.defaultExperiment is not None:
        assert _values(own.defaultExperiment, TIMES) == _values(theirs.defaultExperiment, TIMES)
    for kind in ("coSimulation", "modelExchange"):
        mine, other = getattr(own, kind), getattr(theirs, kind)
        assert (mine is None) == (other is None)
        assert not mine or mine.modelIdentifier == other.modelIdentifier
        for name, their_name in FLAGS.items():
            if hasattr(other, their_name):
                assert getattr(mine, name) == getattr(other, their_name), name
    for a, b in zip(own.modelVariables, theirs.modelVariables, strict=True):
        assert _values(a, (*VARIABLE, "shape", "start")) == _values(
            b, (*VARIABLE, "shape", "start")
        )
        assert (a.derivative and a.derivative.name) == (b.derivative and b.derivative.name)
        assert (a.declaredType is None) == (b.declaredType is None)
        if a.declaredType is not None:
            assert _values(a.declaredType, TYPE) == _values(b.declaredType, TYPE)
            items = [(item.name, item.value) for item in b.declaredType.items]
            assert [*a.declaredType.items] == items
    for kind in ("outputs", "derivatives"):
        for a, b in zip(getattr(own, kind), getattr(theirs, kind), strict=True):
            assert a.variable.name == b.variable.name
            lists = [u.dependencies and [v.name for v in u.dependencies] for u in (a, b)]
            assert lists[0] == lists[1]


def _foreign(folder: Path) -> list[Path]:
    return [valve_fmu(folder, fmi) for fmi in (2, 3)]


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_description_of_an_fmu_is_that_of_fmpy(fmi: str, tmp_path: Path) -> None:
    paths = [
        pam.build("Isotonic", fmi=fmi),
        models.fmu(models.delayed_mix, fmi),
        *_foreign(tmp_path),
    ]
    for path in paths:
        theirs = fmpy.read_model_description(str(path), validate=False)
        _assert_same(read_description(path), theirs)


def test_arrays_and_aliases_are_those_of_fmpy(tmp_path: Path) -> None:
    (tmp_path / "modelDescription.xml").write_text(ARRAYS)
    theirs = fmpy.read_model_description(str(tmp_path / "modelDescription.xml"), validate=False)
    own = read_description(tmp_path)
    _assert_same(own, theirs)
    assert [v.name for v in own.modelVariables][-1] == "y" and own.numberOfContinuousStates == 3


def test_limits_of_an_unsigned_integer_are_read() -> None:
    text = ARRAYS.replace('<UInt64 name="n"', '<UInt64 name="n" min="1" max="9"')
    variable = parse(io.BytesIO(text.encode())).modelVariables[0]
    assert (variable.type, variable.min, variable.max) == ("UInt64", "1", "9")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('<Output valueReference="2"', '<Output valueReference="8"', "'8' is of no variable"),
        ('dependencies="6 4"', 'dependencies="6 9"', "'9' is of no variable"),
        ('derivative="2"', 'derivative="9"', "'9' is of no variable"),
        ('declaredType="Mode"', 'declaredType="Mood"', r"'mode' \(line 11\) .* type 'Mood'"),
        ('<Float64 name="z"', '<Complex name="z"', r"'z' \(line 14\) .* unknown type 'Complex'"),
        ('causality="input"', 'causality="parameter" variability="continuous"', "'continuous'"),
        ('fmiVersion="3.0"', 'fmiVersion="1.0"', "this is FMI '1.0'"),
    ],
)
def test_what_refers_to_nothing_is_refused(old: str, new: str, message: str) -> None:
    assert old in ARRAYS
    with pytest.raises(InputError, match=message):
        parse(io.BytesIO(ARRAYS.replace(old, new).encode()))
