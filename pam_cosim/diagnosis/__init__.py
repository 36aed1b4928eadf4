"""Fit and catalogue of effects -> which effect is missing."""

from pam_cosim.diagnosis.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.check import Check, Help, check
from pam_cosim.diagnosis.diagnose import Diagnosis, diagnose
from pam_cosim.diagnosis.events import (
    AllRunsAsked,
    BaseFitted,
    BegunAnew,
    CandidateTried,
    EffectLookedAt,
    EffectsLookedAt,
    Event,
    FittingBegun,
    Judged,
    LedgerKept,
    Listener,
    LookFirst,
    NothingTried,
    OutliersSetAside,
    Remark,
    StepsSought,
    StepsTimed,
)
from pam_cosim.diagnosis.explanation import LearnedModel
from pam_cosim.diagnosis.identifiability import ConfusedPair, DetectableEffect, Identifiability, ParameterPrecision
from pam_cosim.diagnosis.message import Message
from pam_cosim.diagnosis.missing_term import LeftInSignal, MissingTerm
from pam_cosim.diagnosis.next_experiment import NextExperiment
from pam_cosim.diagnosis.posterior import Explanation, Posterior
from pam_cosim.diagnosis.verdict import Verdict

__all__ = [
    "Explanation",
    "Posterior",
    "ConfusedPair",
    "AllRunsAsked",
    "BaseFitted",
    "BegunAnew",
    "Candidate",
    "CandidateTried",
    "Check",
    "Diagnosis",
    "EffectLookedAt",
    "EffectsLookedAt",
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
    "LookFirst",
    "Message",
    "MissingTerm",
    "NextExperiment",
    "NothingTried",
    "OutliersSetAside",
    "Remark",
    "DetectableEffect",
    "StepsSought",
    "StepsTimed",
    "Identifiability",
    "Verdict",
    "check",
    "diagnose",
]
