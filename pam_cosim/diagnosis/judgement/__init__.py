"""Fitted models -> which one the data ask for, how sure that is, and the run that would decide."""
