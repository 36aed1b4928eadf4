from __future__ import annotations

import pytest

from pam_cosim.reporting import comparison_report
from tests.reporting.html_checks import checked
from tests.reporting.synthetic import make_comparison, make_data


@pytest.mark.full
def test_scores_stand_in_readable_units():
    comparison = make_comparison(make_data(), 10.0)
    text = checked(comparison_report(comparison)).text
    s = comparison.scores["holdout"]["x"]
    assert f"holdout x {s.rmse * 1e3:.2f} mm 0.200 mm" in text
    assert "in x (noise 0.200 mm)" in text
    assert "valve.C_A 0.7000" in text


def test_deterministic_and_safe():
    data = make_data(("fit",), samples=15, title="<script>1</script>")
    comparison = make_comparison(data, 3.0)
    html = comparison_report(comparison)
    assert html == comparison_report(comparison)
    assert "<script" not in html
    assert "<script>1</script>" in checked(html).text
