"""Events of a diagnosis as data for listeners; the text of an event is the line that is printed."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

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
class Remark(Event):
    """A step of the diagnosis, as text alone."""

    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class BaseFitted(Event):
    """The model without effects is fitted: what candidates are compared with."""

    fit: Fit

    def __str__(self) -> str:
        return f"base model refitted: {describe_fit(self.fit)}"


@dataclass(frozen=True)
class EffectProbed(Event):
    """The change of the samples by one more effect was computed; no line is printed of it.

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
