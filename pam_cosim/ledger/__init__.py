"""Data set and model -> which balance fails, and its missing term as a signal."""

from pam_cosim.ledger.estimate import keep_ledger
from pam_cosim.ledger.ledger import (
    BalanceEntry,
    BinnedTerm,
    Ledger,
    Map,
    TermSeries,
    binned,
    mapped,
)

__all__ = [
    "BinnedTerm",
    "TermSeries",
    "BalanceEntry",
    "Ledger",
    "Map",
    "binned",
    "keep_ledger",
    "mapped",
]
