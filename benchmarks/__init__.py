"""Measurements of how good the software is."""
