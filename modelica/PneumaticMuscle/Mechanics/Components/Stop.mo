within PneumaticMuscle.Mechanics.Components;
model Stop "What carries the load at full extension: the braid, as a one-sided spring and damper"
  extends Icons.Stop;
  Interfaces.Flange flange_a "Load end"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  Interfaces.Flange flange_b "Fixed end"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Types.Length L0 "Length at which it engages" annotation (Dialog(group="Geometry"));
  parameter Types.TranslationalStiffness k = 2e5 "Stiffness" annotation (Dialog(group="Mechanics"));
  parameter Types.TranslationalDamping d = 500 "Damping" annotation (Dialog(group="Mechanics"));
  Types.Length x "Contraction";
  Types.Velocity v "Speed of contraction";
  Types.Force f "Force that lifts the load";
protected
  constant Types.Length x_smooth = 1e-5 "Travel over which the stop engages";
  constant Types.Force f_smooth = 0.01 "Force over which its one-sidedness is rounded";
equation
  x = L0 - (flange_b.s - flange_a.s);
  v = der(x);
  f = 0.5*(1 - tanh(x/x_smooth))*Functions.smoothMax(-k*x - d*v, f_smooth);
  flange_a.f = -f;
  flange_b.f = f;
  annotation (Documentation(info="<html>
<p>max(0, -k x - d v) for x &lt; 0, zero otherwise. At zero gauge pressure nothing in
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17) carries the load; the braid does. Engages over
0.01 mm, below what a displacement sensor resolves.</p>
</html>"));
end Stop;
