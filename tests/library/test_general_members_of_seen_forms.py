"""What the general members of families leave of laws that a second author wrote, who did not know them."""

from __future__ import annotations

from collections.abc import Iterator
from inspect import isclass, ismodule

import pytest

from rig.effect import Effect
from rig.seen import further
from tests.library.rig_spans import left_of
from tests.library.shelf import effects

LEFT = (
    0.05  # of what the base model leaves; beside three standard deviations of noise nobody sees it
)
LESS_WELL = {"flushed_probe": 0.1}
"""A thermometer in a stream that changes sides: not contained."""

NEAR = {
    "guard_tube": {
        "F_0": 0.5,
        "F_p": 0.5,
        "growth": 1.2,
        "curvature": 0.2,
        "d": 4e-4,
        "n_direct": 1.0,
    }
}
"""Where the fit of a friction that is not there below a contraction begins; from elsewhere it ends at 0.1 and more."""


def _forms() -> Iterator[type[Effect]]:
    for module in filter(ismodule, vars(further).values()):
        for form in vars(module).values():
            if isclass(form) and form.__module__ == module.__name__ and issubclass(form, Effect):
                yield form


FORMS = {form.form: form for form in _forms()}


def _general(family: str) -> list[str]:
    """The general members, those of vessels first: they are quicker to fit."""
    return sorted((e.name for e in effects() if e.family == family and e.general), reverse=True)


@pytest.mark.full
@pytest.mark.parametrize("form", sorted(FORMS))
def test_a_general_member_takes_a_law_of_its_family_away(form: str) -> None:
    law = FORMS[form]()
    shares = []
    for name in _general(law.family):
        left, size = left_of(law, name, NEAR.get(form))
        shares.append(left / size)
        if shares[-1] < LEFT:
            break
    assert min(shares) < LESS_WELL.get(form, LEFT)


def test_every_form_is_there() -> None:
    assert len(FORMS) == 32
