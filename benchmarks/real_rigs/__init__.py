"""Rigs of others, and rival methods: how well a run is predicted that was never fitted."""
