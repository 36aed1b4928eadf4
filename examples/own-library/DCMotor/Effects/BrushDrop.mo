within DCMotor.Effects;
model BrushDrop "Voltage between brushes and commutator"
  extends Interfaces.VoltageEffect(final family="brush_contact", final absent="V_b=0");
  parameter Real V_b(unit="V", min=0, max=4, nominal=0.5) = 0.3 "Voltage of both contacts";
  parameter Real i_s(unit="A", min=0.01, max=1) = 0.1 "Current over which it turns round";
equation
  v = V_b*tanh(i/i_s);
  annotation (Documentation(info="<html>
<p>v = V_b tanh(i/i_s). Source: Fitzgerald, Kingsley and Umans, section 7.2: about 2 V for carbon brushes, whatever
the current.</p>
<p>Fingerprint: the speed falls short by the same amount at small and large currents, and more where the current
changes its sign.</p>
</html>"));
end BrushDrop;
