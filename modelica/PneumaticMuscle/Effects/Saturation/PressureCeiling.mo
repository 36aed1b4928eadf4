within PneumaticMuscle.Effects.Saturation;
model PressureCeiling "The pressure reading ends at an upper limit"
  extends Interfaces.PressureChannel;
  extends FamilyMember(final absent="high=1e7");
  parameter Types.GaugePressure high(min=-1.01e5, max=1e7, nominal=1e5) = 2e4 "Upper limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(above="p"));
protected
  constant Types.GaugePressure width = 100 "Pressure over which the corner is rounded";
equation
  y = high - Functions.smoothMax(high - u, width);
  annotation (Documentation(info="<html>
<p>y = min(u, high), with a corner that is rounded over 100 Pa. Source: the range of a converter, of an amplifier, or
the stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search begins at a
limit that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the pressure is flat above a value that it reaches again and again; all other readings go on.</p>
</html>"));
end PressureCeiling;
