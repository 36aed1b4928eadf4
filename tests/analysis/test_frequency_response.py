"""Responses by sines against formulas, against the linear model, and of an FMU without model exchange."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.special import jv

import pam_cosim as pam
from tests.fmu import models
from tests.simulation.misbehaving import repacked

BENT = """
model Bent "A lag behind a curve whose harmonics are known"
  input Real u(start=0);
  output Real y;
  output Real direct;
  parameter Real tau(unit="s") = 0.5;
  Real x(start=0, fixed=true);
equation
  tau*der(x) = u - x;
  y = x;
  direct = exp(u);
end Bent;
"""


@pytest.fixture
def bent(tmp_path: Path) -> str:
    (tmp_path / "Bent.mo").write_text(BENT)
    return str(tmp_path / "Bent.mo")


def test_against_formulas(bent: str) -> None:
    """A lag answers as its formula says; exp(a sin) has the harmonics I_n(a) of the modified Bessel functions."""
    frequencies = np.geomspace(0.1, 10.0, 9)
    response = pam.frequency_response(bent, input="u", amplitude=0.8, frequencies=frequencies)
    np.testing.assert_allclose(
        response.gain[:, 0], 1 / (1 + 2j * np.pi * frequencies * 0.5), rtol=1e-5
    )
    harmonics = [abs(jv(n, 0.8j)) for n in range(11)]
    np.testing.assert_allclose(response.gain[:, 1], 2 * harmonics[1] / 0.8, rtol=1e-7)
    expected = np.sqrt(sum(h**2 for h in harmonics[2:])) / harmonics[1]
    np.testing.assert_allclose(response.distortion[:, 1], expected, rtol=1e-7)
    np.testing.assert_allclose(response.shift[:, 1], harmonics[0] - 1, rtol=1e-7)
    assert (response.distortion[:, 0] < 1e-4).all() and response.settled.all()
    assert response.bandwidth["y"] == pytest.approx(
        1 / np.pi, rel=0.1
    )  # between points that are a factor of 1.8 apart


def test_small_sines_are_linear_and_large_ones_are_not() -> None:
    point = {"at": {"p": "1 bar"}, "free": ["u_in"]}
    words = {"input": "u_in", "outputs": ["p", "x"], "frequencies": [0.1, 1, 20]} | point
    small = pam.frequency_response("Isotonic", {"u_out": 0.25}, amplitude="1 mA", **words)
    np.testing.assert_allclose(small.gain, small.linear_gain, rtol=2e-3)
    assert small.settled.all() and small.distortion.max() < 0.01
    large = pam.frequency_response("Isotonic", {"u_out": 0.25}, amplitude="40 mA", **words)
    assert large.distortion[0, 1] > 0.1 and abs(large.gain[0, 1] / large.linear_gain[0, 1]) > 1.1


@pytest.mark.full
def test_without_model_exchange(tmp_path: Path) -> None:
    """Found by runs from the start values; the same numbers."""
    built = models.fmu(models.lag)
    text = __import__("zipfile").ZipFile(built).read("modelDescription.xml").decode()
    begin = text.index("<ModelExchange")
    end = (
        text.index("/>", begin) + 2
        if "</ModelExchange>" not in text
        else text.index("</ModelExchange>") + 16
    )
    alone = repacked(built, tmp_path / "alone.fmu", {text[begin:end]: ""})
    interface = pam.describe(str(alone))
    [name] = interface.inputs
    words = {"input": name, "amplitude": 0.5, "frequencies": [0.2, 2.0]}
    by_runs, whole = (
        pam.frequency_response(str(alone), **words),
        pam.frequency_response(str(built), **words),
    )
    assert by_runs.linear is None and np.isnan(by_runs.linear_gain).all() and by_runs.settled.all()
    np.testing.assert_allclose(by_runs.gain, whole.gain, rtol=3e-3)
    with pytest.raises(pam.InputError, match="a steady state needs an FMU for model exchange"):
        pam.frequency_response(str(alone), at={name: 1.0}, free=[name], **words)


def test_what_has_not_settled_is_said(bent: str) -> None:
    response = pam.frequency_response(
        "Isotonic", input="u_in", amplitude="100 mA", frequencies=[20.0], most_periods=2
    )
    assert (
        response.periods.tolist() == [2]
        and not response.settled.any()
        and "(not settled)" in str(response)
    )


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"input": "u"}, "no input 'u'"),
        ({"outputs": ["q"]}, "no variable 'q'"),
        ({"amplitude": "3 kg"}, "u_in=3 kg"),
        ({"amplitude": 0}, "the amplitude must be above zero"),
        ({"frequencies": [0.0]}, "frequencies must be above zero"),
        ({"frequencies": []}, "frequencies must be above zero"),
        ({"at": {"p": 1e5}}, "about an equilibrium"),
        ({"most_periods": 1}, "two periods"),
    ],
)
def test_bad_input(words: dict, message: str) -> None:
    with pytest.raises(pam.InputError, match=message):
        pam.frequency_response("Isotonic", **({"input": "u_in", "amplitude": 0.01} | words))
