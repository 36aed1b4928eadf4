within PneumaticMuscle.Laws.Lines;
model CurvedTube "A tube whose flow is a curved power of the drop of the square of pressure, another each way"
  extends Interfaces.TwoGasPorts;
  extends Icons.Line;
  parameter Real G(unit="kg/(s.Pa)") "Conductance at the reference drop, at ambient pressure"
    annotation (Dialog(group="Flow"));
  parameter Real a(unit="1") "Exponent of the conductance at the reference drop" annotation (Dialog(group="Flow"));
  parameter Real b(unit="1") "Quadratic coefficient of the exponent, by the logarithm of the drop"
    annotation (Dialog(group="Flow"));
  parameter Real c(unit="1") "Exponent of the pressure upstream" annotation (Dialog(group="Flow"));
  parameter Real asymmetry(unit="1") "Asymmetry of the logarithm of the conductance between both directions"
    annotation (Dialog(group="Flow"));
  outer Ambient ambient "Surroundings";
equation
  m_flow = Functions.curvedFlow(port_a.p, port_b.p, ambient.p, G, a, b, c, asymmetry);
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Functions.curvedFlow\">Functions.curvedFlow</a> of the pressures at its ends.
a = b = c = asymmetry = 0 is <a href=\"modelica://PneumaticMuscle.Laws.Lines.LaminarTube\">LaminarTube</a>.</p>
</html>"));
end CurvedTube;
