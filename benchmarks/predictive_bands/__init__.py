"""How often held-out runs lie within the bands that were predicted."""
