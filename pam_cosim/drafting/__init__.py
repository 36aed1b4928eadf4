"""From the files of a lab to a data set, in one pass: recordings, evidence for each column, draft.

``recordings`` reads files; ``headings`` reads words by the vocabulary of a library, ``shapes`` what numbers show;
``columns`` and ``time_axis`` say what each column is, and ``evidence`` adds what the user states.
``benches`` takes a bench; ``entries``, ``values`` and ``roles`` say what its data set contains; ``document`` writes it,
``questions`` asks what only the experimenter knows, and ``new`` does one after the other. No bench, no effect and no
word of a field has a name here.
"""

from pam_cosim.drafting.evidence import DraftRequests
from pam_cosim.drafting.new import UnsimulatedDraft, draft
from pam_cosim.drafting.questions import Guess, NewDataSet

__all__ = ["Guess", "NewDataSet", "DraftRequests", "UnsimulatedDraft", "draft"]
