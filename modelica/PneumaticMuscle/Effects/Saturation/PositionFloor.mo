within PneumaticMuscle.Effects.Saturation;
model PositionFloor "The position reading ends at a lower limit"
  extends Interfaces.PositionChannel;
  extends FamilyMember(final absent="low=-1");
  parameter Types.Length low(min=-1, max=1, nominal=0.05) = 5e-3 "Lower limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(below="x"));
protected
  constant Types.Length width = 2e-5 "Position over which the corner is rounded";
equation
  y = low + Functions.smoothMax(u - low, width);
  annotation (Documentation(info="<html>
<p>y = max(u, low), with a corner that is rounded over 20 micrometres. Source: the range of a converter, of an
amplifier, or the stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search
begins at a limit that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the position is flat below a value that it reaches again and again; all other readings go on.</p>
</html>"));
end PositionFloor;
