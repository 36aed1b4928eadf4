within PneumaticMuscle.Effects.ThermocoupleLag;
model ThermocoupleLag "The temperature reading lags"
  extends Interfaces.Thermometer(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="tau=1e-3");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant" annotation (Dialog(group="Effect"));
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
  end if;
equation
  tau*der(T) = port.T - T;
  annotation (Documentation(info="<html>
<p>tau T_dot = T_gas - T. Source: heat balance of a small bead in a gas stream. Typical 0.05 s (bare wire of 25
micrometres) to 10 s (sheathed).</p>
<p>Fingerprint: the temperature is smooth and late; pressure and contraction are right.</p>
</html>"));
end ThermocoupleLag;
