"""An independent simulator of the Doumit-Pardoel chain in SciPy: the rig that produces data with hidden effects.

It shares nothing with the Modelica models: other state variables (gas mass and internal energy instead of
pressure), another regularisation of the orifice, another integrator. It imports nothing of `pam_cosim`, of the tests
or of the benchmarks; those import it.

Effects lie in folders by what has been looked at: `catalogue` has the forms that the catalogue has as well, `seen`
those that it lacks and that were looked at, `blind` those that nobody who works on the diagnosis has looked at.
"""
