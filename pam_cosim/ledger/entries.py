"""What each balance and each instrument explains by itself."""

from __future__ import annotations

from collections.abc import Mapping

from pam_cosim.ledger.ledger import BalanceEntry, SensorReading
from pam_cosim.ledger.sensor import SensorFault
from pam_cosim.ledger.smoothed_models import SmoothedModels


def sensor_readings(rivals: SmoothedModels) -> list[SensorReading]:
    """What a fault of each instrument explains, that of the best explanation first."""
    before, winner = rivals.unaugmented.deviance, rivals.winner
    readings = [
        _reading(f, before - f.deviance, rivals.explained(f.chi2))
        for f in rivals.unaugmented.faults
    ]
    if winner is None or winner.fault is None:
        return readings
    winning_reading = _reading(
        winner.fault, before - winner.deviance, rivals.explained(winner.chi2)
    )
    return [winning_reading, *(r for r in readings if r.signal != winning_reading.signal)]


def balance_entries(rivals: SmoothedModels, shares: Mapping[str, float]) -> dict[str, BalanceEntry]:
    """What an unknown input in each balance explains by itself; in the place of a law, where it explains more."""
    entries: dict[str, BalanceEntry] = {}
    for explanation in filter(None, (rivals.augmented, rivals.replaced)):
        for unknown_input in explanation.unknown_inputs:
            balance = unknown_input.balance
            if balance in entries and explanation is not rivals.replaced:
                continue
            deviance, chi2 = explanation.with_only(unknown_input)
            entry = BalanceEntry(
                balance,
                float(rivals.unaugmented.deviance - deviance),
                rivals.explained(chi2),
                shares.get(balance, 0.0),
                unknown_input.unit,
                unknown_input.meaning,
            )
            if balance not in entries or entry.gain > entries[balance].gain:
                entries[balance] = entry
    return entries


def _reading(fault: SensorFault, evidence: float, explains: float) -> SensorReading:
    return SensorReading(
        fault.signal,
        fault.unit,
        fault.offset,
        fault.offset_deviation,
        fault.gain,
        fault.gain_deviation,
        fault.lag,
        evidence,
        explains,
    )
