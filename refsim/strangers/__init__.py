"""Strangers' rigs: recordings and notes as laboratories have them, several departures from the base model on each."""
