"""An independent SciPy simulator of the Doumit-Pardoel chain: the rig that produces data with hidden effects.

It shares nothing with the Modelica models: other state variables (gas mass and internal energy instead of
pressure), another regularisation of the orifice, another integrator.
"""
