within PneumaticMuscle.Pneumatics.Components;
model PlainOrifice "A round hole of fixed size"
  extends Orifice(final A=C_d*Constants.pi/4*d^2);
  parameter Types.Length d(min=1e-5, max=0.1) = 2.71e-3 "Diameter" annotation (Dialog(group="Geometry"));
  parameter Real C_d(unit="1", min=0.01, max=1.2) = 0.84 "Discharge coefficient" annotation (Dialog(group="Flow"));
  annotation (Documentation(info="<html>
<p>A = C_d pi d^2/4. Sharp-edged holes have C_d from 0.6 to 0.84, rounded ones up to 1.</p>
</html>"));
end PlainOrifice;
