within PneumaticMuscle.Effects.Saturation;
model PositionCeiling "The position reading ends at an upper limit"
  extends Interfaces.PositionChannel;
  extends FamilyMember(final absent="high=1");
  parameter Types.Length high(min=-1, max=1, nominal=0.05) = 5e-3 "Upper limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(above="x"));
protected
  constant Types.Length width = 2e-5 "Position over which the corner is rounded";
equation
  y = high - Functions.smoothMax(high - u, width);
  annotation (Documentation(info="<html>
<p>y = min(u, high), with a corner that is rounded over 20 micrometres. Source: the range of a converter, of an
amplifier, or the stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search
begins at a limit that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the position is flat above a value that it reaches again and again; all other readings go on.</p>
</html>"));
end PositionCeiling;
