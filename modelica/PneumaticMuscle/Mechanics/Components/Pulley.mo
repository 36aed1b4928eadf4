within PneumaticMuscle.Mechanics.Components;
model Pulley "A wheel that two muscles pull against each other"
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
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  Real phi(unit="rad", displayUnit="deg", start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Angle";
  Real w(unit="rad/s", start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Angular velocity";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(phi) = 0;
    der(w) = 0;
  end if;
equation
  flange_1.s = x_0 + r*phi;
  flange_2.s = x_0 - r*phi;
  w = der(phi);
  J*der(w) = r*(flange_1.f - flange_2.f) - d*w;
  annotation (Documentation(info="<html>
<p>J phi_ddot = r (F_1 - F_2) - d phi_dot, with contractions x_0 + r phi and x_0 - r phi: the antagonistic pair that
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (Pitel and Tothova) and Kang describe. Without
pressure nothing holds the angle but the stops at full extension.</p>
</html>"));
end Pulley;
