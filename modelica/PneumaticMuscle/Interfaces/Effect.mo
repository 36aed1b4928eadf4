within PneumaticMuscle.Interfaces;
partial model Effect "Statements of every effect"
  extends Icons.Named;
  constant String family "Family of the effect, an identifier such as elasticity";
  constant String balance "Balance in which it acts: force, mass, energy or sensor";
  constant String absent = "" "Parameter values at which the effect vanishes, such as k=0; empty where there are none";
  constant Boolean general = false
    "General form of its family, named only where the other members do not suffice";
  annotation (Documentation(info="<html>
<p>A class that extends this one is part of the catalogue. Its own public parameters that have both a minimum
and a maximum are estimated when the effect is tried on a measurement, starting from their values.</p>
<p><code>absent</code> lists, as one would write a modification, parameter values with which the model is the base
model again, exactly or in the limit: zero for a strength, one for a factor, a bound for a time constant. A law that
takes the place of another and never equals it leaves it empty.</p>
<p>The annotation <code>__PamCosim(typical={0.95, 1.05})</code> of a parameter states the range that holds it in 95 % of
all rigs, with its source in the documentation of the class. It is a prior: normal, by order of magnitude where the
bounds are positive and far apart.</p>
<p><code>__PamCosim(at_min=\"ViscousFriction\", at_max=\"LinearBladder\")</code> names the effect that is left where
the parameter ends at its minimum or maximum; an empty text: none is left. <code>__PamCosim(above=\"x\")</code>, or
<code>below</code>, says that the parameter lies above all that the signal x shows. Other tools pass over these.</p>
<p><code>general</code> marks a member that bends in every direction its family has. It pays for its many parameters, so
a law of few that leaves noise is preferred.</p>
</html>"));
end Effect;
