"""Tests; a package, so that `tests.reference` can be run as a module."""
