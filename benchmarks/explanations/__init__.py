"""How good the explanation is that stands beside a verdict: the balance, the formula, the time."""
