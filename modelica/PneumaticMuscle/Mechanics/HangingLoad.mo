within PneumaticMuscle.Mechanics;
model HangingLoad "A mass that hangs on the muscle"
  extends Interfaces.Mechanics(shows="x", final F_start=m*Constants.g);
  extends Icons.Load;
  Interfaces.Flange flange "Load end of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Types.Mass m(min=0.001, max=1000) = 2.27 "Mass" annotation (Dialog(group="Load"));
  Types.Length s(start=x_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Position, positive upwards";
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
  annotation (defaultComponentName="load", Documentation(info="<html>
<p>m x_ddot = F - m g, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (16)-(18). It begins where
the muscle carries it without pressure.</p>
</html>"));
end HangingLoad;
