within PneumaticMuscle.Effects.Saturation;
model PressureFloor "The pressure reading ends at a lower limit"
  extends Interfaces.PressureChannel;
  extends FamilyMember(final absent="low=-1.01e5");
  parameter Types.GaugePressure low(min=-1.01e5, max=1e7, nominal=1e5) = 5e3 "Lower limit of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(below="p"));
protected
  constant Types.GaugePressure width = 100 "Pressure over which the corner is rounded";
equation
  y = low + Functions.smoothMax(u - low, width);
  annotation (Documentation(info="<html>
<p>y = max(u, low), with a corner that is rounded over 100 Pa. Source: the range of a converter, of an amplifier, or the
stop of a transducer. Typical the end of the range that was chosen for a smaller signal. A search begins at a limit
that most signals pass, so that it sees which way to go.</p>
<p>Fingerprint: the pressure is flat below a value that it reaches again and again; all other readings go on.</p>
</html>"));
end PressureFloor;
