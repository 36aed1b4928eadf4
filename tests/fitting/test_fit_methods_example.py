"""The example that sets the published swarm beside other methods."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

from tests.documentation.pages import one_line, other_pictures, quoted, stands_in

EXAMPLE = Path(__file__).parents[2] / "examples" / "fit-methods" / "run.py"


@pytest.mark.full
def test_all_methods_come_to_one_optimum_and_the_swarm_alone_does_not(tmp_path: Path) -> None:
    spec = importlib.util.spec_from_file_location("example_fit_methods", EXAMPLE)
    assert spec is not None and spec.loader is not None
    example = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = example
    spec.loader.exec_module(example)
    made = example.fits(tmp_path / "data")
    ends = [fit.residuals["fit"].chi2_reduced for fit in made.values()]
    assert max(ends) == pytest.approx(min(ends), rel=1e-3)
    assert made["particle-swarm"].search.chi2_reduced[-1] > 1.01 * min(ends)
    assert made["least-squares"].evaluations < 60 < made["particle-swarm"].search.evaluations
    example.draw(made, tmp_path / "fit-methods.png")
    assert other_pictures(tmp_path, by_processor=True) == []
    said = [
        quote for quote in quoted("fitting.md") if "simulations" in quote or "generation" in quote
    ]
    assert len(said) == 6
    # some simulations more or less on another processor
    assert [q for q in said if not stands_in(q, one_line(example.told(made)), more=3)] == []
