"""Hypotheses about a data set rather than a model: that what it states of a parameter is wrong."""

from __future__ import annotations

from pam_cosim.catalogue import EffectClass
from pam_cosim.measurement import DataSet
from pam_cosim.model.domain import WRONG_PARAMETER
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import ratio_to_stated

_BALANCE = "sensor"


def stated_parameters(data: DataSet, interface: Interface) -> list[EffectClass]:
    """One hypothesis for each parameter that every run states and no fit moves: by a factor it is something else."""
    first, *others = data.runs
    stated = [
        name
        for name, value in first.parameters.items()
        if value and name in interface.parameters and name not in data.free_names
        if all(run.parameters.get(name) for run in others)
    ]
    return [_hypothesis(name, data) for name in sorted(stated)]


def _hypothesis(name: str, data: DataSet) -> EffectClass:
    ratio = ratio_to_stated(name)
    return EffectClass(
        name=ratio,
        qualified_name=ratio,
        family=WRONG_PARAMETER,
        balance=_BALANCE,
        description=f"{name} is not what the data set states",
        documentation="",
        parameters=(ratio,),
        component_name=name,
        file=data.folder,
        absent={ratio: 1.0},
    )
