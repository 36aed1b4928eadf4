within PneumaticMuscle.Effects.Saturation;
model ForceCeiling "The force reading ends at an upper limit"
  extends Interfaces.ForceChannel;
  extends FamilyMember(final absent="high=1e5");
  parameter Types.Force high(min=-1e4, max=1e5, nominal=100) = 20 "Upper limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(above="F"));
protected
  constant Types.Force width = 0.1 "Force over which the corner is rounded";
equation
  y = high - Functions.smoothMax(high - u, width);
  annotation (Documentation(info="<html>
<p>y = min(u, high), with a corner that is rounded over 0.1 N. Source: the range of a converter, of an amplifier, or the
stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search begins at a limit
that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the force is flat above a value that it reaches again and again; all other readings go on.</p>
</html>"));
end ForceCeiling;
