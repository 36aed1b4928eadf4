"""Data set and model -> which balance fails, and its missing term as a signal."""

from pam_cosim.ledger.estimate import keep_ledger
from pam_cosim.ledger.ledger import Band, Course, Entry, Ledger, Map, Reading, binned, mapped

__all__ = ["Band", "Course", "Entry", "Ledger", "Map", "Reading", "binned", "keep_ledger", "mapped"]
