"""Forms of effects that the catalogue, modelica/PneumaticMuscle/Effects, has as well: the same law, written again."""
