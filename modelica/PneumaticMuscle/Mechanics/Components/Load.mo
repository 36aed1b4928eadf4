within PneumaticMuscle.Mechanics.Components;
model Load "A hanging mass"
  extends Icons.Load;
  Interfaces.Flange flange "Where it hangs"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Types.Mass m(min=0.001, max=1000) = 2.27 "Mass" annotation (Dialog(group="Load"));
  parameter Types.Length s_start "Position at the start" annotation (Dialog(group="Start"));
  parameter Types.Dynamics dynamics = ambient.dynamics "How it begins: fixed, at rest, or as nothing else says"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  Types.Length s(start=s_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Position, positive upwards";
  Types.Velocity v(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Speed";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(s) = 0;
    der(v) = 0;
  end if;
equation
  flange.s = s;
  v = der(s);
  m*der(v) = flange.f - m*Constants.g;
  annotation (Documentation(info="<html>
<p>m x_ddot = F - m g, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (16)-(18), positive
upwards.</p>
</html>"));
end Load;
