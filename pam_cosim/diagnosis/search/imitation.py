"""Which effects of other families do nearly the same to the samples as one, so that it may stand in their place."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.fitting import Linear


def likest_members(
    effect: str, probes: Sequence[EffectProbe], base: Linear, others: Collection[str]
) -> list[str]:
    """Of each of some families the member that can do the likest to the samples as an effect, the likest first.

    To first order about the base model, and beyond what its free parameters can do: by the cosine of the angle between
    the direction in which the effect moves the samples most and all that the member can do.

    Args:
        effect: what they are compared with.
        probes: what each effect does beside the base model.
        base: the base model there.
        others: names of the families.
    """
    spaces = {p.effect: _space(p, base) for p in probes if p.effect == effect or p.family in others}
    if effect not in spaces or not spaces[effect].size:
        return []
    main = spaces[effect][:, :1]
    cosine = {
        p.effect: float(np.linalg.norm(spaces[p.effect].T @ main))
        for p in probes
        if p.family in others
    }
    family = {p.effect: p.family for p in probes}
    first: dict[str, str] = {}
    for name in sorted(cosine, key=lambda name: (-cosine[name], name)):
        first.setdefault(family[name], name)
    return list(first.values())


def _space(probe: EffectProbe, base: Linear) -> Array:
    """(m, k) orthonormal, the main one first: how an effect moves the samples and free parameters cannot."""
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
