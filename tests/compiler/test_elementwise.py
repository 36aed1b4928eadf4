"""Expressions on arrays of numbers."""

import numpy as np
import pytest

from pam_cosim.compiler import elementwise
from pam_cosim.errors import ModelError

X = np.linspace(-2.0, 2.0, 9)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("-x^2 + 3*x/2", -(X**2) + 3 * X / 2),
        ("(x/k)*sqrt((x/k)^2 + 1e-4)", X / 0.5 * np.sqrt((X / 0.5) ** 2 + 1e-4)),
        ("exp(x/k) - 1", np.exp(X / 0.5) - 1),
        ("tanh(x) - sin(x)*cos(x)", np.tanh(X) - np.sin(X) * np.cos(X)),
        ("1", 1.0),
    ],
)
def test_value(text: str, expected: np.ndarray) -> None:
    np.testing.assert_allclose(elementwise(text, {"x": X, "k": 0.5}), expected, rtol=1e-15)


@pytest.mark.parametrize(
    "text", ["y", "open(x)", "x.real", "if x > 0 then 1 else 2", '"a"', "__import__(x)", "x +"]
)
def test_what_is_no_arithmetic_is_refused(text: str) -> None:
    with pytest.raises(ModelError):
        elementwise(text, {"x": X})
