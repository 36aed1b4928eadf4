"""Tests; a package, so that a test can import the helpers of another."""
