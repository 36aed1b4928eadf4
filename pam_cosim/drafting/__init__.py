"""From the files of a lab to a data set: what columns are, which bench they feed, and what was guessed.

``vocabulary`` holds those of the field in three languages; ``columns`` applies them to recordings, ``bench_choice``
to benches, and what means the same is joined; ``bench`` takes one. ``mapping`` brings numbers to the bench's names,
units, signs and zeros; ``rest`` tells where nothing moves; ``noise``, ``roles`` and ``values`` say the rest of the
file; ``document`` writes it, ``folder`` puts it in place, ``summary`` says what was guessed, and ``new`` does one
after the other. No bench and no effect has a name here.
"""

from pam_cosim.drafting.new import draft
from pam_cosim.drafting.requests import DraftRequests
from pam_cosim.drafting.summary import Guess, NewDataSet

__all__ = ["Guess", "NewDataSet", "DraftRequests", "draft"]
