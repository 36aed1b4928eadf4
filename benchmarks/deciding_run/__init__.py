"""One more run: designed to decide, or drawn at random."""
