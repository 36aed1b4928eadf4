within PneumaticMuscle.Effects.Saturation;
model ForceFloor "The force reading ends at a lower limit"
  extends Interfaces.ForceChannel;
  extends FamilyMember(final absent="low=-1e4");
  parameter Types.Force low(min=-1e4, max=1e5, nominal=100) = 20 "Lower limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(below="F"));
protected
  constant Types.Force width = 0.1 "Force over which the corner is rounded";
equation
  y = low + Functions.smoothMax(u - low, width);
  annotation (Documentation(info="<html>
<p>y = max(u, low), with a corner that is rounded over 0.1 N. Source: the range of a converter, of an amplifier, or the
stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search begins at a limit
that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the force is flat below a value that it reaches again and again; all other readings go on.</p>
</html>"));
end ForceFloor;
