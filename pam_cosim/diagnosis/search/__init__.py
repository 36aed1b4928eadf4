"""Effects of the catalogue -> fitted models: looked at, ranked, fitted, challenged."""
