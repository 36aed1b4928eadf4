"""Files that try to do more than hold data."""
