"""The blind score: an independent rig hides effects in data sets, the diagnosis has to name them.

Nothing here but `score` and `one` imports pam_cosim: the simulator, its formulas and its integrator are those of
`rig`.
"""
