"""Which runs a sweep makes."""

from __future__ import annotations

import numpy as np
import pandas
import pytest

import pam_cosim as pam
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.sweeps import design_of

FACE = Interface(
    "Test",
    inputs={"u": Variable("u", "A")},
    parameters={"p": Variable("p", "Pa", min=0.0), "m": Variable("m", "kg")},
)


def test_a_grid_is_every_combination_the_last_name_fastest() -> None:
    design = design_of({"p": ["1 bar", "2 bar"], "m": [1, 2, 3]}, FACE)
    assert design.points.tolist() == [[p, m] for p in (1e5, 2e5) for m in (1, 2, 3)]
    assert design.units == {"p": "Pa", "m": "kg"} and list(design.axes["p"]) == [1e5, 2e5]


def test_a_span_is_written_as_on_the_command_line() -> None:
    assert design_of({"p": "1 bar:3 bar:3", "m": [1]}, FACE).points[:, 0].tolist() == [
        1e5,
        2e5,
        3e5,
    ]
    drawn = design_of({"p": "1 bar:3 bar"}, FACE, "random", 9).points
    assert np.array_equal(drawn, design_of({"p": (1e5, 3e5)}, FACE, "random", 9).points)


@pytest.mark.parametrize(
    "vary",
    [
        {"p": [1e5, "2 bar"], "m": ["1 kg", "500 g"]},
        [{"p": "1 bar", "m": 1}, {"p": 2e5, "m": "500 g"}],
        pandas.DataFrame({"p": [1e5, 2e5], "m": [1.0, 0.5]}),
    ],
    ids=["columns", "rows", "frame"],
)
def test_a_list_is_taken_run_by_run(vary: object) -> None:
    assert design_of(vary, FACE, "list").points.tolist() == [[1e5, 1.0], [2e5, 0.5]]


@pytest.mark.parametrize("kind", ["random", "latin-hypercube"])
def test_random_runs_are_the_same_with_the_same_seed_and_within_their_ranges(kind: str) -> None:
    ranges = {"p": ("1 bar", "3 bar"), "m": (2.0, 4.0)}
    one, again, other = (design_of(ranges, FACE, kind, 50, seed).points for seed in (1, 1, 2))
    assert np.array_equal(one, again) and not np.array_equal(one, other)
    assert (one >= [1e5, 2.0]).all() and (one <= [3e5, 4.0]).all()


def test_a_latin_hypercube_has_one_run_in_each_slice_of_each_axis() -> None:
    points = design_of({"p": (0.0, 1.0), "m": (0.0, 1.0)}, FACE, "latin-hypercube", 40, 3).points
    for column in points.T:
        assert sorted(np.floor(column * 40).astype(int)) == list(range(40))


@pytest.mark.parametrize(
    ("vary", "more", "words"),
    [
        ({}, {}, "nothing is varied"),
        ({"p": []}, {}, "'p' is varied over no value at all"),
        ({"p": 3.0}, {}, "give a list of values"),
        ({"p": "1 bar:3 bar"}, {}, "p=1 bar:3 bar': write FROM:TO:N"),
        ({"p": "1:3:3"}, {"kind": "random", "runs": 2}, "write FROM:TO"),
        ({"q": [1.0]}, {}, "no parameter or input 'q'"),
        ({"p": ["3 kg"]}, {}, "p=3 kg"),
        ({"p": [1.0, -1.0]}, {}, "must be at least 0"),
        ({"p": [1.0]}, {"kind": "gird"}, "there is no design 'gird'"),
        ({"p": [1.0], "m": [1.0, 2.0]}, {"kind": "list"}, "p 1, m 2"),
        ([{"p": 1.0}, {"m": 1.0}], {"kind": "list"}, "the same names"),
        ({"p": (2.0, 1.0)}, {"kind": "random", "runs": 3}, "lowest and its highest"),
        ({"p": (1.0, 2.0)}, {"kind": "random"}, "give the number of runs"),
        ({"p": (1.0, 2.0)}, {"kind": "random", "runs": 0}, "between 1 and"),
        ({"p": [1.0, 2.0]}, {"runs": 3}, "leave out the number of runs"),
        ({"p": range(2000), "m": range(2000)}, {}, "4000000 combinations"),
    ],
)
def test_what_is_no_design_is_refused(vary: object, more: dict[str, object], words: str) -> None:
    with pytest.raises(pam.InputError) as refused:
        design_of(vary, FACE, **more)  # type: ignore[arg-type]
    assert words in str(refused.value)
