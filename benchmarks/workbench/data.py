"""What is moved: six runs of 10 s with three signals of 1001 samples, from the independent rig."""

from __future__ import annotations

from pathlib import Path

from rig.measurement import measure, write_data_set
from rig.named import effect_of
from rig.plan import default_plan


def six_runs(folder: Path) -> Path:
    """Writes the data set."""
    write_data_set(folder, measure(default_plan(), [effect_of("elasticity:linear")], seed=1))
    return folder
