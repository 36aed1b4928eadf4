within PneumaticMuscle.Effects.Saturation;
model TemperatureCeiling "The temperature reading ends at an upper limit"
  extends Interfaces.TemperatureChannel;
  extends FamilyMember(final absent="high=1500");
  parameter Types.Temperature high(min=100, max=1500, nominal=300) = 295 "Upper limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(above="T"));
protected
  constant Real width = 0.05 "Temperature over which the corner is rounded";
equation
  y = high - Functions.smoothMax(high - u, width);
  annotation (Documentation(info="<html>
<p>y = min(u, high), with a corner that is rounded over 0.05 K. Source: the range of a converter, of an amplifier, or
the stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search begins at a
limit that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the temperature is flat above a value that it reaches again and again; all other readings go on.</p>
</html>"));
end TemperatureCeiling;
