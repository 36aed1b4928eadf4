within PneumaticMuscle.Benches;
model LumpedLinear "Linear model of three states, pressure, length and its rate, AM Fig. 9"
  extends Icons.Bench;
  Interfaces.Signals.GaugePressureInput p_in(start=4.5e5) "Set pressure of the regulator"
    annotation (Placement(transformation(extent={{-110,-35},{-90,-15}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle"
    annotation (Placement(transformation(extent={{90,40},{110,60}}),
      iconTransformation(extent={{90,50},{110,70}})));
  Interfaces.Signals.LengthOutput L "Length, from that at the operating point"
    annotation (Placement(transformation(extent={{90,-35},{110,-15}}),
      iconTransformation(extent={{90,-10},{110,10}})));
  Interfaces.Signals.ForceOutput F "Pull of the muscle"
    annotation (Placement(transformation(extent={{90,-110},{110,-90}}),
      iconTransformation(extent={{90,-70},{110,-50}})));
  replaceable model PressureChannel = Instruments.Sensors.DirectPressure constrainedby Interfaces.PressureChannel
    "Measuring channel of the pressure"
    annotation (choicesAllMatching=true);
  replaceable model PositionChannel = Instruments.Sensors.DirectPosition constrainedby Interfaces.PositionChannel
    "Measuring channel of the position"
    annotation (choicesAllMatching=true);
  replaceable model ForceChannel = Instruments.Sensors.DirectForce constrainedby Interfaces.ForceChannel
    "Measuring channel of the force"
    annotation (choicesAllMatching=true);
  replaceable model Recorder = Instruments.Sensors.SharedClock constrainedby Interfaces.Recorder
    "Recorder of the readings"
    annotation (choicesAllMatching=true);
  parameter Types.GaugePressure p_0(min=0, max=1e6) = 2.5e5 "Gauge pressure at the operating point"
    annotation (Dialog(group="Operating point"));
  parameter Types.Time tau(min=1e-3, max=10) = 0.1 "Time constant of the pressure" annotation (Dialog(group="Law"));
  parameter Types.Area C_1(min=1e-6, max=1e-2, nominal=1e-4) = 5.7238e-4 "Pull per gauge pressure"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalStiffness C_2(min=0, max=1e5) = 8061.8 "Pull per length"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalStiffness k(min=0, max=1e5) = 500 "Stiffness of what it pulls"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalDamping b(min=0, max=1e4) = 60 "Damping" annotation (Dialog(group="Law"));
  parameter Types.Mass m(min=0.001, max=1000) = 2 "Mass" annotation (Dialog(group="Law"));
  parameter Types.Force F_0(min=0, max=1e5) = 0 "Pull at the operating point"
    annotation (Dialog(group="Operating point"));
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.GaugePressure P(start=p_0, fixed=dynamics == Types.Dynamics.FixedInitial) "Pressure";
  Types.Velocity v(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Rate of the length";
  PressureChannel channel_p(u=P, dynamics=dynamics) "Measuring channel of the pressure"
    annotation (Placement(transformation(extent={{-95,-140},{-55,-100}})));
  PositionChannel channel_L(u=l, dynamics=dynamics) "Measuring channel of the position"
    annotation (Placement(transformation(extent={{-45,-140},{-5,-100}})));
  ForceChannel channel_F(u=F_0 + C_1*(P - p_0) + C_2*l, dynamics=dynamics) "Measuring channel of the force"
    annotation (Placement(transformation(extent={{5,-140},{45,-100}})));
  Recorder recorder "Recorder of the readings"
    annotation (Placement(transformation(extent={{55,-140},{95,-100}})));
protected
  Types.Length l(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Length, from that at the operating point";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(P) = 0;
    der(l) = 0;
    der(v) = 0;
  end if;
equation
  tau*der(P) = p_in - P;
  der(l) = v;
  m*der(v) = -C_1*(P - p_0) - (C_2 + k)*l - b*v;
  connect(channel_p.y, p)
    annotation (Line(points={{-55,-120}, {-50,-120}, {-50,50}, {100,50}}, color={0,0,127}));
  connect(channel_L.y, L)
    annotation (Line(points={{-5,-120}, {0,-120}, {0,-25}, {100,-25}}, color={0,0,127}));
  connect(channel_F.y, F)
    annotation (Line(points={{45,-120}, {50,-120}, {50,-95}, {99,-95}, {99,-100}, {100,-100}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-100,-150},{100,100}}), graphics={
    Line(points={{-70,80}, {70,80}}, color={60,60,60}, thickness=1),
    Line(points={{-50,80}, {-50,50}, {-65,42}, {-35,26}, {-65,10}, {-35,-6}, {-50,-14}, {-50,-40}}, color={0,110,60}),
    Line(points={{0,80}, {0,30}}, color={0,110,60}),
    Line(points={{-15,30}, {15,30}}, color={0,110,60}),
    Line(points={{-20,45}, {-20,5}, {20,5}, {20,45}}, color={0,110,60}),
    Line(points={{0,5}, {0,-40}}, color={0,110,60}),
    Line(points={{50,80}, {50,-40}}, color={0,90,160}, thickness=1, arrow={Arrow.Filled, Arrow.None}, arrowSize=12),
    Rectangle(extent={{-65,-90}, {65,-40}}, lineColor={60,60,60}, fillColor={190,190,190},
    fillPattern=FillPattern.Solid),
    Text(extent={{-40,-85}, {40,-45}}, textString="m", textColor={60,60,60}),
    Text(extent={{-98,-34}, {-54,-24}}, textString="C_2 + k", textColor={60,60,60}),
    Text(extent={{22,18}, {42,30}}, textString="b", textColor={60,60,60}),
    Text(extent={{55,12}, {95,24}}, textString="C_1 P", textColor={60,60,60})}),
    experiment(StopTime=2, Interval=0.002, Tolerance=1e-6), Documentation(info="<html>
<p>d/dt [P, L, L_dot] = [-1/tau, 0, 0; 0, 0, 1; -C_1/m, -(C_2 + k)/m, -b/m] [P, L, L_dot] + [1/tau, 0, 0] P_in and
F = F_0 + C_1 dP + C_2 dL, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, dynamic model; L counts
from the operating point p_0. The default is the step from 2.5 to 4.5 bar. tau, k, b and m are not given; these are for
illustration.</p>
<p>C_1 and C_2 are those of AM Fig. 7 about 6 bar and 10 % strain, but C_1 is printed as 5.7238e-5: the force equation
with the stated parameters gives 5.7239e-4 m2 and 8061.8 N/m, so a power of ten was lost. The step lies below the
operating point: at 3.5 bar and 10 % the same equation gives 4.28e-4 m2 and 5706 N/m.</p>
</html>"));
end LumpedLinear;
