within PneumaticMuscle.Pneumatics.Components;
model Droop "A pressure that is lost in proportion to the mass flow"
  extends Interfaces.TwoGasPorts;
  extends Icons.Orifice;
  parameter Real R(unit="Pa.s/kg", min=1e3, max=1e10, nominal=1e7) "Pressure lost per mass flow"
    annotation (Dialog(group="Flow"));
equation
  m_flow = (port_a.p - port_b.p)/R;
  annotation (Documentation(info="<html>
<p>p_a - p_b = R m_flow, in both directions: the flow characteristic of a regulator
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6953</a>) as a straight line.</p>
</html>"));
end Droop;
