"""Fit and catalogue of effects -> which effect is missing."""

from pam_cosim.diagnosis.description.explanation import LearnedModel
from pam_cosim.diagnosis.diagnose import Diagnosis, diagnose
from pam_cosim.diagnosis.judgement.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.judgement.events import (
    BaseFitted,
    CandidateTried,
    EffectProbed,
    Event,
    Judged,
    LedgerKept,
    Listener,
    Remark,
)
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.judgement.missing_term import LeftInSignal, MissingTerm
from pam_cosim.diagnosis.judgement.next_experiment import NextExperiment
from pam_cosim.diagnosis.judgement.posterior import Explanation, Posterior
from pam_cosim.diagnosis.judgement.verdict import Verdict
from pam_cosim.diagnosis.planning.check import Check, Help, check
from pam_cosim.diagnosis.planning.identifiability import (
    ConfusedPair,
    DetectableEffect,
    Identifiability,
    ParameterPrecision,
)

__all__ = [
    "Explanation",
    "Posterior",
    "ConfusedPair",
    "BaseFitted",
    "Candidate",
    "CandidateTried",
    "Check",
    "Diagnosis",
    "EffectProbed",
    "Event",
    "FailedTrial",
    "Help",
    "Judged",
    "ParameterPrecision",
    "LearnedModel",
    "LedgerKept",
    "LeftInSignal",
    "Listener",
    "Message",
    "MissingTerm",
    "NextExperiment",
    "Remark",
    "DetectableEffect",
    "Identifiability",
    "Verdict",
    "check",
    "diagnose",
]
