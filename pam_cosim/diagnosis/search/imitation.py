"""Which effects of other families do nearly the same to the samples as one, so that it may stand in their place."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.fitting import Linear


def likest_members(
    effects: Collection[str],
    probes: Sequence[EffectProbe],
    base: Linear,
    others: Collection[str],
) -> dict[str, list[str]]:
    """By effect, of each of some families the member that can do the likest to the samples, the likest first.

    To first order about the base model, and beyond what its free parameters can do: by the cosine of the angle between
    the direction that the effect and its parameters have most in common and all that the member can do.

    Args:
        effects: what they are compared with; none is like one that was not looked at, or does nothing.
        probes: what each effect does beside the base model.
        base: the base model there.
        others: names of the families.
    """
    family = {p.effect: p.family for p in probes}
    spaces = {
        p.effect: _space(p, base) for p in probes if p.effect in effects or p.family in others
    }
    members = {name: space for name, space in spaces.items() if family[name] in others}
    likest: dict[str, list[str]] = {}
    for effect in effects:
        space = spaces.get(effect)
        first: dict[str, str] = {}
        if space is not None and space.size:
            cosine = {name: float(np.linalg.norm(m.T @ space[:, 0])) for name, m in members.items()}
            for name in sorted(cosine, key=lambda name: (-cosine[name], name)):
                first.setdefault(family[name], name)
        likest[effect] = list(first.values())
    return likest


def _space(probe: EffectProbe, base: Linear) -> Array:
    """(m, k) orthonormal, how an effect moves the samples and free parameters cannot.

    The main one first: which most of its parameters, and the effect as a whole, have in common.
    """
    own = np.isin(probe.linear.names, probe.own_parameters)
    free = np.linalg.qr(probe.linear.slopes[:, ~own])[0]
    range_of = (probe.linear.high - probe.linear.low)[own]
    moves = np.column_stack(
        [probe.linear.residual - base.residual, probe.linear.slopes[:, own] * range_of]
    )
    moves = moves - free @ (free.T @ moves)
    sizes = np.linalg.norm(moves, axis=0)
    directions, shares, _ = np.linalg.svd(
        moves[:, sizes > 0] / sizes[sizes > 0], full_matrices=False
    )
    return np.asarray(directions[:, shares > np.sqrt(CRITERIA.search.idle)])
