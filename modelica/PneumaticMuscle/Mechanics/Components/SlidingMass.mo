within PneumaticMuscle.Mechanics.Components;
partial model SlidingMass "A mass that moves with the load end of a muscle"
  extends Icons.Named;
  Interfaces.Flange flange "Load end of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Types.Mass m(min=0.001, max=1000) "Mass that moves" annotation (Dialog(group="Load"));
  parameter Types.Length s_start "Position at the start" annotation (Dialog(group="Start"));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  Types.Length s(start=s_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Position, positive in contraction";
  Types.Velocity v(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Speed";
protected
  Types.Force f_back "Force that pulls it back";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(s) = 0;
    der(v) = 0;
  end if;
equation
  flange.s = s;
  v = der(s);
  m*der(v) = flange.f - f_back;
  annotation (Documentation(info="<html>
<p>Newton's law, m x_ddot = F - f_back. Left to the extending class: the equation of f_back, a value of m and of
s_start.</p>
</html>"));
end SlidingMass;
