"""Fit and catalogue of effects -> which effect is missing."""

from pam_cosim.diagnosis.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.check import Check, Help, check
from pam_cosim.diagnosis.diagnose import Diagnosis, diagnose
from pam_cosim.diagnosis.events import (
    AllRunsSearched,
    BaseFitted,
    CandidateTried,
    DoubtRaised,
    EffectProbed,
    EffectsProbed,
    Event,
    FittingBegun,
    Judged,
    LedgerKept,
    Listener,
    NothingTried,
    OutliersSetAside,
    Remark,
    SearchRestarted,
    StepTimesFound,
    StepTimesSought,
)
from pam_cosim.diagnosis.explanation import LearnedModel
from pam_cosim.diagnosis.identifiability import (
    ConfusedPair,
    DetectableEffect,
    Identifiability,
    ParameterPrecision,
)
from pam_cosim.diagnosis.message import Message
from pam_cosim.diagnosis.missing_term import LeftInSignal, MissingTerm
from pam_cosim.diagnosis.next_experiment import NextExperiment
from pam_cosim.diagnosis.posterior import Explanation, Posterior
from pam_cosim.diagnosis.verdict import Verdict

__all__ = [
    "Explanation",
    "Posterior",
    "ConfusedPair",
    "AllRunsSearched",
    "BaseFitted",
    "SearchRestarted",
    "Candidate",
    "CandidateTried",
    "Check",
    "Diagnosis",
    "EffectProbed",
    "EffectsProbed",
    "Event",
    "FailedTrial",
    "FittingBegun",
    "Help",
    "Judged",
    "ParameterPrecision",
    "LearnedModel",
    "LedgerKept",
    "LeftInSignal",
    "Listener",
    "DoubtRaised",
    "Message",
    "MissingTerm",
    "NextExperiment",
    "NothingTried",
    "OutliersSetAside",
    "Remark",
    "DetectableEffect",
    "StepTimesSought",
    "StepTimesFound",
    "Identifiability",
    "Verdict",
    "check",
    "diagnose",
]
