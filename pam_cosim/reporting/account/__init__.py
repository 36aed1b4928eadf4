"""The sentences of a product, and rows of texts, without a picture; for reports, the terminal and the page."""

from pam_cosim.diagnosis.judgement.verdict_sentences import (
    compared_sentence,
    error_sentence,
    headline,
    instrument_sentence,
    kind_name,
    meaning,
    not_tried_sentence,
    probability_rows,
    probability_sentence,
)
from pam_cosim.reporting.account.diagnosis_rows import (
    balance_shares,
    candidate_row,
    missing_rows,
    parameter_rows,
    place_of,
    summary_rows,
)
from pam_cosim.reporting.account.learned_part import learned_part
from pam_cosim.reporting.account.ledger_words import against_of, ledger_words, telling_entries
from pam_cosim.reporting.account.next_run import next_run
from pam_cosim.reporting.account.wording import (
    estimate_texts,
    percent,
    quantity_text,
    remark,
    unit_text,
)
from pam_cosim.wording import words

__all__ = [
    "against_of",
    "balance_shares",
    "candidate_row",
    "compared_sentence",
    "error_sentence",
    "estimate_texts",
    "headline",
    "instrument_sentence",
    "kind_name",
    "learned_part",
    "ledger_words",
    "meaning",
    "missing_rows",
    "next_run",
    "not_tried_sentence",
    "parameter_rows",
    "percent",
    "place_of",
    "probability_rows",
    "probability_sentence",
    "quantity_text",
    "remark",
    "summary_rows",
    "telling_entries",
    "unit_text",
    "words",
]
