"""What is wrong with a model is said with file, line and column, or with the names of what does not fit."""

import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.errors import ModelError
from tests.compiler.run import MODELS, WRONG, compiled


@pytest.mark.parametrize(
    ("name", "line", "column", "words"),
    [
        ("Syntax", 5, 3, ["expected ';'", "'x'"]),
        ("Unclosed", 1, 16, ["string is not closed"]),
        ("UnknownClass", 3, 3, ["Tanks.Tnk", "not found"]),
        ("UnknownBase", 2, 11, ["base class 'Tanks.Benchh' not found"]),
        ("UnknownName", 2, 14, ["'velocity' not found"]),
        ("UnknownModifier", 3, 10, ["no 'AA' in Tanks.Tank"]),
        ("TooFew", 1, 7, ["1 equations for 2 variables", "no equation determines 'force'"]),
        ("TooMany", 1, 7, ["2 equations for 1 variables", "TooMany.mo:5: x = 5;"]),
        ("InputDerivative", 1, 7, ["input 'position'", "InputDerivative.mo:5"]),
        ("FinalModified", 5, 7, ["final"]),
        ("NotReplaceable", 6, 23, ["'B' is not replaceable"]),
        ("Unfit", 2, 48, ["'Tanks.Tank' does not fit", "p_start", "Muscles.PartialGas"]),
        ("NoInner", None, None, ["outer World world", "inner World world"]),
        ("Contradiction", 1, 7, ["overdetermined", "right.h"]),
        ("When", 5, 3, ["'when' is not supported"]),
        ("NoValue", 2, 18, ["parameter 'k' has no value"]),
        ("AssertFails", 5, 3, ["n must be positive"]),
        ("MissingEach", 2, 19, ["each"]),
        ("PartialComponent", 2, 18, ["partial class Tanks.TwoPorts"]),
        ("Connectors", 5, 3, ["differ in"]),
    ],
)
def test_error_names_place_and_cause(name, line, column, words):
    file = WRONG / f"{name}.mo"
    with pytest.raises(ModelError) as caught:
        compile_model(str(file), root=MODELS)
    error = caught.value
    for word in words:
        assert word in str(error)
    if line is not None:
        assert (error.file, error.line, error.column) == (file, line, column)


def test_unknown_model_suggests_one_of_that_name():
    with pytest.raises(
        ModelError, match=r"no model 'Muscle\.Bench'; did you mean Muscles\.Bench or Tanks\.Bench"
    ):
        compiled("Muscle.Bench")


def test_missing_file():
    with pytest.raises(ModelError, match="no such file"):
        compile_model("nowhere.mo", root=MODELS)


def test_a_package_is_no_model():
    with pytest.raises(ModelError, match="'Tanks' is a package"):
        compiled("Tanks")


def test_a_partial_model_is_refused():
    with pytest.raises(ModelError, match="partial"):
        compiled("Tanks.TwoPorts")
