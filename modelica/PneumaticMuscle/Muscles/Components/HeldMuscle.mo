within PneumaticMuscle.Muscles.Components;
model HeldMuscle "A sleeve under a given pressure at a given contraction ratio, without any motion"
  extends Icons.Muscle;
  Interfaces.Signals.GaugePressureInput p_gauge "Gauge pressure"
    annotation (Placement(transformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.RealInput eps(unit="1") "Contraction ratio"
    annotation (Placement(transformation(extent={{-110,-50},{-90,-30}})));
  parameter Types.Length L0(min=0.01, max=2) = 0.3 "Length at rest" annotation (Dialog(group="Geometry"));
  parameter Types.Length D0(min=0.001, max=0.2) = 0.01 "Diameter at rest" annotation (Dialog(group="Geometry"));
  parameter Real alpha_0(unit="rad", displayUnit="deg", min=0.1, max=0.9) = 23*Constants.pi/180 "Braid angle at rest"
    annotation (Dialog(group="Geometry"));
  Types.Force F "Pull";
  replaceable model Braid = Laws.Forces.Kang constrainedby Interfaces.Braid "Law of force without terms of speed"
    annotation (choicesAllMatching=true);
  Braid braid(L0=L0, D0=D0, turns=L0*tan(alpha_0)/(Constants.pi*D0), t_wall=1e-3) "Sleeve"
    annotation (Placement(transformation(extent={{-20,-20},{20,20}})));
protected
  Pneumatics.Components.Supply supply(p_gauge=p_gauge) "What sets the pressure"
    annotation (Placement(transformation(extent={{-80,-20},{-40,20}})));
  Mechanics.Components.Held held(s=L0*eps) "What holds the load end"
    annotation (Placement(transformation(extent={{-20,-80},{20,-40}})));
  Mechanics.Components.Fixed fixed(s0=L0) "What holds the other end"
    annotation (Placement(transformation(extent={{-20,40},{20,80}})));
equation
  connect(supply.port, braid.port)
    annotation (Line(points={{-40,0}, {-20,0}}, color={0,90,160}));
  connect(held.flange, braid.flange_a)
    annotation (Line(points={{0,-40}, {0,-20}}, color={0,110,60}));
  connect(fixed.flange, braid.flange_b)
    annotation (Line(points={{0,40}, {0,20}}, color={0,110,60}));
  F = braid.F;
  annotation (Documentation(info="<html>
<p>Statics: the contraction may jump from one value to the next, so nothing here may depend on its speed, and forces in
parallel with the sleeve, which know their speed, find no terminals. Numbers of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equation 1.</p>
</html>"));
end HeldMuscle;
