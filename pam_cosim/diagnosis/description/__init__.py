"""What no effect of the catalogue explains -> a formula, and the effect that has it."""
