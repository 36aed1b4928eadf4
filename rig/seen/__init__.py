"""Forms of effects that the catalogue lacks and that were looked at while the diagnosis was made or improved."""
