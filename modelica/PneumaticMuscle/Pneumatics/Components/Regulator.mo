within PneumaticMuscle.Pneumatics.Components;
model Regulator "A pressure regulator: the pressure follows the input with a short lag"
  extends Interfaces.PressureSource;
  extends Icons.GasSource;
  Interfaces.Signals.GaugePressureInput p_wanted "Gauge pressure wanted"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Time tau(min=1e-4, max=10) = 2e-3 "Time constant" annotation (Dialog(group="Dynamics"));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.GaugePressure p(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Gauge pressure";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(p) = 0;
  end if;
equation
  tau*der(p) = p_wanted - p;
  port.p = ambient.p + p;
  annotation (Documentation(info="<html>
<p>tau p_dot = p_wanted - p. It gives whatever mass the pressure needs. The lag, below what is sampled, lets volumes be
attached, whose flow depends on the rate of the pressure.</p>
</html>"));
end Regulator;
