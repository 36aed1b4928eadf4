"""What a model shows, and how it is set: its interface, values with units, names of its variables."""
