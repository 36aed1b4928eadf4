"""The blind score: an independent rig hides effects in data sets, the diagnosis has to name them.

Nothing here but `score` and `one` imports pam_cosim: the simulator, its formulas, its integrator and the writer of
data sets are those of `rig`.
"""
