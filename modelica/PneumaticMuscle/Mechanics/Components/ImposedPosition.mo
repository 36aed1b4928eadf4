within PneumaticMuscle.Mechanics.Components;
model ImposedPosition "Moves a flange to the position of the input, through a fast critically damped filter"
  extends Icons.Motion;
  Interfaces.Flange flange "Moved flange"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Signals.LengthInput s_wanted "Position wanted"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Time tau(min=1e-4, max=1) = 5e-3 "Time constant of the filter" annotation (Dialog(group="Dynamics"));
  parameter Types.Length s_start = 0 "Position at the start" annotation (Dialog(group="Start"));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  Types.Length s(start=s_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Position";
  Types.Velocity v(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Speed";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(s) = 0;
    der(v) = 0;
  end if;
equation
  flange.s = s;
  der(s) = v;
  tau^2*der(v) = s_wanted - s - 2*tau*v;
  annotation (Documentation(info="<html>
<p>tau^2 s_ddot + 2 tau s_dot + s = s_wanted. The volume of a muscle changes with the speed of its end, so an imposed
position would have to be differentiated; the filter has the derivatives. A step is followed to 1 % within 6.6 tau, and
a ramp with a delay of 2 tau, 10 ms; keep tau below the sampling interval.</p>
</html>"));
end ImposedPosition;
