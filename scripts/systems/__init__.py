"""FMUs on systems other than the one at hand: built, loaded and simulated there."""
