"""Coverage of bands on real rigs: a model error that is taken out of a band leaves the band that is made without."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.predictive_bands.half_widths import with_discrepancy
from benchmarks.real_rigs.bands import FITTED, Share, _share, line
from pam_cosim import study
from tests.fitting.models import discharge, vessel_data


def test_a_model_error_is_taken_out_of_a_band() -> None:
    times = np.linspace(0.0, 60.0, 61)
    wrong = discharge(times=times)[0] + 4e3 * np.sin(times / 4.0)
    data = vessel_data(clean=wrong, times=times)
    fitted = study.fit(data)
    wide, narrow = (
        study.predict(fitted, run="run", samples=30, discrepancy=on).bands["p"]
        for on in (True, False)
    )
    assert wide.discrepancy is not None and narrow.discrepancy is None
    widths = [(b.reading_high - b.reading_low) / 2 for b in (wide, narrow)]
    assert np.median(widths[0]) > 1.2 * np.median(widths[1])
    assert with_discrepancy(widths[0], wide.discrepancy, None, 0.0) == pytest.approx(widths[1])
    half = (wide.mean_high - wide.mean_low) / 2
    less = with_discrepancy(half, wide.discrepancy, None, 60.0)
    assert float(less) == pytest.approx((narrow.mean_high - narrow.mean_low) / 2)

    run, kept, span = data.runs[0], np.ones(61, dtype=bool), {"p": 1e6}
    share = _share("outside", FITTED, wide, wide.discrepancy, None, run, kept, "p", span)
    assert share.inside == pytest.approx(narrow.coverage)
    assert share.width == pytest.approx(float(np.median(widths[1])) / 1e6)
    far = replace(run, measurements={"p": run.measurements["p"] + 1e6})
    off = _share("outside", FITTED, wide, wide.discrepancy, None, far, kept, "p", span)
    assert off.inside == 0.0 and not off.mean
    lost = _share("outside", FITTED, None, None, None, run, kept, "p", span)
    assert lost.inside == 0.0 and not lost.mean


def test_the_line_counts() -> None:
    found = [Share("outside", FITTED, v, v > 0.6, 0.02) for v in (0.5, 0.75)]
    assert line("rig", found) == "| rig |  |  |  |  | 62 %, 1 of 2, ± 2 % |  |"
