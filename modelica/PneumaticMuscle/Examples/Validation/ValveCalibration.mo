within PneumaticMuscle.Examples.Validation;
model ValveCalibration "Flow and effective area of the valve by current at fifteen supplies, DP section 4.4"
  extends Icons.Validation;
  parameter Real current_rate(unit="A/s", min=0.01, max=1) = 0.035 "Rise of the current"
    annotation (Dialog(group="Operation"));
  constant Types.GaugePressure p_supply[15] = {30e3 + 250e3*(i - 1)/14 for i in 1:15} "Supplies from 30 to 280 kPa";
  output Types.Current u = current_rate*time "Current";
  output Types.MassFlowRate m_flow[15] = valve.m_flow "Mass flow rates into the open air";
  output Real V_flow[15](each unit="m3/s") "The same as volume of ambient air";
  output Types.Area A[15] "Effective areas that (41) finds in the flows";
  output Types.Area A_choked[15] "The same if the flow is taken to be choked, N = 1";
  output Types.Area A_gauge[15] "The same if in addition the gauge pressure is taken for the absolute one";
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-80,40},{-40,80}})));
  Pneumatics.Components.Supply supply[15](p_gauge=p_supply) "Air supplies"
    annotation (Placement(transformation(extent={{-80,-20},{-40,20}})));
  Pneumatics.Components.Orifice valve[15](each A=C_A*Functions.openingArea(u)) "The valve at each supply"
    annotation (Placement(transformation(extent={{-20,-20},{20,20}})));
  Pneumatics.Components.Atmosphere atmosphere[15] "Open air"
    annotation (Placement(transformation(extent={{80,-20},{40,20}})));
protected
  constant Real C_A(unit="1") = 0.699 "Calibration of DP section 4.4, as in Components.ValvePair";
  constant Types.Area A_unit = 1 "Area for which (41) is evaluated";
  constant Real K =
    sqrt(Constants.gamma/Constants.R*(2/(Constants.gamma + 1))^((Constants.gamma + 1)/(Constants.gamma - 1))) "DP (42)";
equation
  for i in 1:15 loop
    connect(supply[i].port, valve[i].port_a)
      annotation (Line(points={{-40,0}, {-20,0}}, color={0,90,160}));
    connect(valve[i].port_b, atmosphere[i].port)
      annotation (Line(points={{20,0}, {40,0}}, color={0,90,160}));
    V_flow[i] = m_flow[i]*Constants.R*ambient.T/ambient.p;
    A[i] = A_unit*m_flow[i]/Functions.isentropicFlow(supply[i].port.p, ambient.p, ambient.T, A_unit);
    A_choked[i] = m_flow[i]*sqrt(ambient.T)/(K*supply[i].port.p);
    A_gauge[i] = m_flow[i]*sqrt(ambient.T)/(K*p_supply[i]);
  end for;
  annotation (experiment(StopTime=10, Interval=0.05, Tolerance=1e-6), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> calibrate the valve at fifteen supplies from 30
to 280 kPa (which, they do not say: evenly spaced here) against the open air, and find an effective area from each flow
by (41). Neither flows nor areas are printed. These are the model's own: the area by (41) is the one that went in,
whatever the supply. The other two show what a conversion does to the same flows: below 90.5 kPa the valve does not
choke, and a gauge pressure in the place of an absolute one makes the area larger by p_atm/p_gauge.</p>
</html>"));
end ValveCalibration;
