within PneumaticMuscle.Mechanics;
model AntagonisticPair "A pulley that two muscles pull against each other"
  extends Interfaces.Mechanics(shows="x_1", final F_start=0);
  extends Icons.Pulley;
  Interfaces.Flange flange_1 "Muscle that turns it forwards"
    annotation (Placement(transformation(extent={{-70,90},{-50,110}})));
  Interfaces.Flange flange_2 "Muscle that turns it backwards"
    annotation (Placement(transformation(extent={{50,90},{70,110}})));
  parameter Types.Length r(min=1e-3, max=1) = 0.03 "Radius" annotation (Dialog(group="Geometry"));
  parameter Real J(unit="kg.m2", min=1e-6, max=100) = 2e-3 "Moment of inertia with what it carries"
    annotation (Dialog(group="Mechanics"));
  parameter Real d(unit="N.m.s/rad", min=0, max=100) = 0.02 "Bearing friction" annotation (Dialog(group="Mechanics"));
  parameter Types.Length x_0(min=0, max=1) = 0.03 "Contraction of both muscles in the middle position"
    annotation (Dialog(group="Geometry"));
  Components.Pulley wheel(r=r, J=J, d=d, x_0=x_0) "Wheel"
    annotation (Placement(transformation(extent={{-40,-40},{40,40}})));
equation
  connect(flange_1, wheel.flange_1)
    annotation (Line(points={{-60,100}, {-60,45}, {-24,45}, {-24,40}}, color={0,110,60}));
  connect(flange_2, wheel.flange_2)
    annotation (Line(points={{60,100}, {60,45}, {24,45}, {24,40}}, color={0,110,60}));
  annotation (defaultComponentName="pulley", Documentation(info="<html>
<p>J phi_ddot = r (F_1 - F_2) - d phi_dot,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.Pulley\">Components.Pulley</a>. The contractions are x_0 + r
phi and x_0 - r phi, so that one of them says the angle.</p>
</html>"));
end AntagonisticPair;
