"""What the documentation says of coupling errors: orders, and chosen steps against fixed ones at equal cost."""

from __future__ import annotations

import pytest

from benchmarks import coupling


def test_order_and_error_at_cost_of_a_known_series() -> None:
    points = [{"step": h, "error": 3 * h**2, "cost": 1 / h} for h in (0.1, 0.05, 0.02)]
    assert coupling.order_of(points) == pytest.approx(2)
    assert coupling.error_at_cost(points, 30) == pytest.approx(3 / 30**2, rel=1e-6)
    assert coupling.error_at_cost(points, 5) is None


@pytest.mark.full
def test_chosen_steps_beat_fixed_ones_where_the_muscle_rests() -> None:
    costs = coupling.costs(True, fixed=(1e-2, 2.5e-3), tolerances=(1e-4,))
    (chosen,) = costs[coupling.CHOSEN]
    fixed = costs[coupling.FIXED_STEPS]
    assert chosen["cost"] < fixed[0]["cost"] and chosen["error"] < fixed[0]["error"] / 10
    assert chosen["cost"] < fixed[1]["cost"] / 4 and chosen["error"] < 1.5 * fixed[1]["error"]


@pytest.mark.full
def test_orders_of_all_methods() -> None:
    for name, points in coupling.orders((2e-3, 1e-3, 5e-4)).items():
        assert coupling.order_of(points) == pytest.approx(2 if "linear" in name else 1, abs=0.1), (
            name
        )
