"""What happens in a diagnosis, as data: whoever listens draws it, and as text it is the line that is printed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from pam_cosim.comparison import Doubt
from pam_cosim.diagnosis.judgement.candidate import Attempt, Candidate, FailedTrial, describe_fit
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.judgement.verdict import Verdict
from pam_cosim.fitting import Fit
from pam_cosim.ledger import Ledger
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class Event(Printed):
    """Something that happened; as text a line, or nothing where there is no line about it.

    Attributes:
        detail: a result of the step that the last headline named.
    """

    detail: ClassVar[bool] = False

    @property
    def message(self) -> Message:
        """The line, which knows the event."""
        return Message(str(self), detail=self.detail, event=self)


Listener = Callable[[Event], object]


@dataclass(frozen=True)
class OutliersSetAside(Event):
    """Single samples that are far off their neighbours; how many, by signal."""

    counts: Mapping[str, int]

    def __str__(self) -> str:
        counts = ", ".join(f"{count} of {name}" for name, count in self.counts.items())
        return f"single samples far off their neighbours are set aside: {counts}"


@dataclass(frozen=True)
class BaseFitted(Event):
    """The model without effects is fitted: what candidates are compared with."""

    fit: Fit

    def __str__(self) -> str:
        return f"base model refitted: {describe_fit(self.fit)}"


@dataclass(frozen=True)
class DoubtRaised(Event):
    """What a person should look at before an effect is said to be missing."""

    doubt: Doubt

    def __str__(self) -> str:
        return f"LOOK FIRST: {self.doubt.text}"


@dataclass(frozen=True)
class NothingTried(Event):
    """The base model leaves noise."""

    def __str__(self) -> str:
        return "what remains is noise: no effect is tried"


@dataclass(frozen=True)
class EffectsProbed(Event):
    """It is looked what each of some effects would change, beside others."""

    count: int
    beside: tuple[str, ...] = ()

    def __str__(self) -> str:
        beside = f" beside {' + '.join(self.beside)}" * bool(self.beside)
        return f"looking at what each of {self.count} effects would change{beside}"


@dataclass(frozen=True)
class EffectProbed(Event):
    """One more of the effects of the last ``EffectsProbed`` is done; no line is printed of it.

    Attributes:
        done, count: how many of how many.
    """

    done: int
    count: int

    @property
    def status(self) -> str:
        """For a line that changes in its place."""
        return f"looking at what each of {self.count} effects would change: {self.done} of {self.count} done"


@dataclass(frozen=True)
class StepTimesSought(Event):
    """Steps of commands may come between two samples: where is sought."""

    def __str__(self) -> str:
        return "giving each step of a command its time between two samples"


@dataclass(frozen=True)
class SearchRestarted(Event):
    """What was tried before no longer counts."""


@dataclass(frozen=True)
class StepTimesFound(SearchRestarted):
    """So many steps of commands got a time between two samples."""

    steps: int

    def __str__(self) -> str:
        return f"{self.steps} steps of commands come between samples, where they leave least: all begins anew"


@dataclass(frozen=True)
class AllRunsSearched(SearchRestarted):
    """What leaves noise in the fitted runs does not hold in the others."""

    def __str__(self) -> str:
        return "what explains the fitted runs does not hold in the held-out ones: all begins anew, with all runs fitted"


@dataclass(frozen=True)
class FittingBegun(Event):
    """So many models are fitted, "in a few steps" or "to the end"; each is a ``CandidateTried``."""

    count: int
    how: str

    def __str__(self) -> str:
        return f"fitting {self.how}: {self.count} model{'s' if self.count > 1 else ''}"


@dataclass(frozen=True)
class RunsLeftOut(Event):
    """Runs are left out in turn, so many times, to see which effects are needed whichever they are."""

    folds: int

    def __str__(self) -> str:
        return f"leaving out runs in turn, in {self.folds} folds: which effects are needed in all?"


@dataclass(frozen=True)
class CandidateTried(Event):
    """A model with some effects was fitted, or could not be; its comparison has no samples."""

    detail: ClassVar[bool] = True
    attempt: Attempt

    def __str__(self) -> str:
        c = self.attempt
        result = (
            f"could not be fitted: {c.failure}"
            if isinstance(c, FailedTrial)
            else describe_fit(c.fit)
        )
        return f"{' + '.join(c.effects)} ({c.family}): {result}"


@dataclass(frozen=True)
class Judged(Event):
    """The answer, before the balances are opened; no line is printed of it, for the diagnosis itself says it.

    Attributes:
        base: the base model, fitted. candidates: every model that was tried, best first. path: what was added.
    """

    verdict: Verdict
    base: Fit
    candidates: tuple[Candidate, ...]
    path: tuple[Candidate, ...]


@dataclass(frozen=True)
class LedgerKept(Event):
    """The balances of the base model."""

    ledger: Ledger


@dataclass(frozen=True)
class Remark(Event):
    """Whatever else there is to say."""

    text: str

    def __str__(self) -> str:
        return self.text


def listened(
    say: Callable[[Message], None], progress: Listener | None
) -> Callable[[Message], None]:
    """Tells each line to ``say``, and what it is about to ``progress``; what has no line to that alone."""

    def tell(message: Message) -> None:
        if message.strip():
            say(message)
        if progress is not None and isinstance(message.event, Event):
            progress(message.event)

    return tell
