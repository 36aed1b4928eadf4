within PneumaticMuscle.Effects.Saturation;
model TemperatureFloor "The temperature reading ends at a lower limit"
  extends Interfaces.TemperatureChannel;
  extends FamilyMember(final absent="low=100");
  parameter Types.Temperature low(min=100, max=1500, nominal=300) = 294 "Lower limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(below="T"));
protected
  constant Real width = 0.05 "Temperature over which the corner is rounded";
equation
  y = low + Functions.smoothMax(u - low, width);
  annotation (Documentation(info="<html>
<p>y = max(u, low), with a corner that is rounded over 0.05 K. Source: the range of a converter, of an amplifier, or the
stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search begins at a limit
that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the temperature is flat below a value that it reaches again and again; all other readings go on.</p>
</html>"));
end TemperatureFloor;
