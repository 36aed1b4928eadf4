within PneumaticMuscle.Mechanics;
model ImposedForce "A drive that imposes the force at the load end"
  extends Interfaces.Mechanics(shows="x", F_start=30);
  extends Icons.Motion;
  Interfaces.Flange flange "Load end of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Signals.ForceInput F_load(start=30) "Imposed force, positive in pull"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Mass m(min=0.001, max=1000) = 0.5 "Mass that moves" annotation (Dialog(group="Load"));
  parameter Types.TranslationalDamping d(min=0, max=1e4) = 20 "Damping of the guide"
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
  m*der(v) = flange.f - F_load - d*v;
  annotation (defaultComponentName="drive", Documentation(info="<html>
<p>m x_ddot = F - F_load - d x_dot, Newton's law of the end of the muscle with what is fixed to it. F_start is the force
at the start, at which the muscle hangs without pressure. Values are for illustration.</p>
</html>"));
end ImposedForce;
