"""What a verdict that leaves no choice is tested against: models that came near, effects that would hardly show."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from pam_cosim.catalogue import Composition, compose_on, qualified
from pam_cosim.compiler import read_library, read_structure
from pam_cosim.diagnosis.diagnose import Diagnosis
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.fitted_models import MOST_RIVALS
from pam_cosim.diagnosis.planning.check import LARGEST_STRENGTH, check
from pam_cosim.diagnosis.planning.identifiability import DetectableEffect
from pam_cosim.diagnosis.planning.members import laws_of
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Estimate, Fit, fit
from pam_cosim.fmu import build_source
from pam_cosim.model.references import is_ratio, sources_of
from pam_cosim.simulation import Simulator

_MOST = MOST_RIVALS - 1


def challenged(diagnosis: Diagnosis, files: Sequence[Path] = ()) -> list[list[Candidate]]:
    """The models of the verdict, and after them each model that a run should tell from it; one alone: none is known.

    Args:
        diagnosis: with the verdict ``identified`` or ``none_missing``; of any other one nothing is challenged.
        files: further Modelica files, as for the diagnosis.
    """
    if diagnosis.verdict.kind == "identified" and diagnosis.path:
        best = diagnosis.path[-1]
        return [
            laws_of(diagnosis, best),
            *([c] for c in _runners_up(diagnosis, best)),
        ]
    if diagnosis.verdict.kind == "none_missing":
        unchanged = _model_with(diagnosis, "", "", {}, files)
        faint = [
            _model_with(diagnosis, c.effect, c.family, c.values, files)
            for c in _faintest(diagnosis, files)
        ]
        return [[c] for c in (unchanged, *faint) if c is not None]
    return []


def _runners_up(diagnosis: Diagnosis, best: Candidate) -> list[Candidate]:
    """The best model of each other set of families that does not contain the verdict's.

    What contains them can say all that the verdict's model says: no run refutes one by the other.
    """
    family = {c.effect: c.family for c in diagnosis.candidates}

    def families(candidate: Candidate) -> frozenset[str]:
        return frozenset(family.get(effect, effect) for effect in candidate.effects)

    best_by_families: dict[frozenset[str], Candidate] = {}
    for candidate in diagnosis.candidates:
        if not families(candidate) >= families(best):
            best_by_families.setdefault(families(candidate), candidate)
    return list(best_by_families.values())[:_MOST]


def _faintest(diagnosis: Diagnosis, files: Sequence[Path]) -> list[DetectableEffect]:
    """Of each family the effect that the recordings show best, and of these the ones that must be strongest to show."""
    identifiability = check(diagnosis.data, diagnosis.model, files=files, workers=0).identifiability
    detectable_effects = [
        e
        for family, e in identifiability.families.items()
        if e.least <= LARGEST_STRENGTH
        and family not in diagnosis.not_tried
        and not is_ratio(e.effect)
    ]
    return sorted(detectable_effects, key=lambda e: (-e.least, e.effect))[:_MOST]


def _model_with(
    diagnosis: Diagnosis,
    effect: str,
    family: str,
    values: Mapping[str, float],
    files: Sequence[Path],
) -> Candidate | None:
    """The base model with an effect of a strength that is supposed, all else fitted to the recordings.

    Without that fit the runs at hand would refute it: free parameters hide what they can of an effect. None: it has no
    place, or breaks down.
    """
    sources = sources_of(files, diagnosis.model)
    effects = (effect,) if effect else ()
    tree = read_library(files=sources)
    structure = read_structure(qualified(tree, diagnosis.model), files=sources)
    composition = compose_on(tree, structure, effects)
    if composition is None:
        return None
    fitted = (
        diagnosis.base if not effects else _fitted_beside(diagnosis, composition, values, files)
    )
    if fitted is None:
        return None
    supposed = {n: Estimate(value, value, value, at_bound=True) for n, value in values.items()}
    fitted_with_effect = replace(
        fitted, model=composition.name, parameters={**fitted.parameters, **supposed}
    )
    return Candidate(
        effect, family, "", effects, tuple(values), fitted_with_effect, equations=composition.text
    )


def _fitted_beside(
    diagnosis: Diagnosis,
    composition: Composition,
    values: Mapping[str, float],
    files: Sequence[Path],
) -> Fit | None:
    data = diagnosis.data
    source = build_source(
        composition.name, composition.text, files, sensitivities=data.differentiated, lean=True
    )
    try:
        with Simulator(source) as simulator:
            return fit(simulator, data, fixed=values)
    except SimulationFailure:
        return None
