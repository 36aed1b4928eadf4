within PneumaticMuscle.Interfaces;
partial model Effect "What every effect says of itself"
  constant String family "Family of the effect, an identifier such as elasticity";
  constant String balance "Balance in which it acts: force, mass, energy or sensor";
  annotation (Documentation(info="<html>
<p>A class that extends this one is part of the catalogue. Its own public parameters that have both a minimum
and a maximum are estimated when the effect is tried on a measurement, starting from their values.</p>
</html>"));
end Effect;
