within PneumaticMuscle.Mechanics;
model Spring "A spring that the muscle stretches"
  extends Interfaces.Mechanics(shows="x, F", final F_start=F_0);
  extends Icons.Stop;
  Interfaces.Flange flange "Load end of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Types.TranslationalStiffness k(min=1, max=1e6) = 2000 "Stiffness" annotation (Dialog(group="Mechanics"));
  parameter Types.Force F_0(min=0, max=1e4) = 5 "Preload, at the start" annotation (Dialog(group="Load"));
  parameter Types.Mass m(min=0.001, max=1000) = 0.5 "Mass that moves" annotation (Dialog(group="Load"));
  parameter Types.TranslationalDamping d(min=0, max=1e4) = 5 "Damping of the guide"
    annotation (Dialog(group="Mechanics"));
  Types.Length s(start=x_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Position";
  Types.Velocity v(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Speed";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(s) = 0;
    der(v) = 0;
  end if;
equation
  flange.s = s;
  v = der(s);
  m*der(v) = flange.f - F_0 - k*(s - x_start) - d*v;
  annotation (Documentation(info="<html>
<p>m x_ddot = F - F_0 - k (x - x_start) - d x_dot: Hooke's spring on a level slide, stretched by F_0 at the start.
Values are for illustration.</p>
</html>"));
end Spring;
