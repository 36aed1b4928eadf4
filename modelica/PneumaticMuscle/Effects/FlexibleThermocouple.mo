within PneumaticMuscle.Effects;
model FlexibleThermocouple "The temperature reading lags, less in dense gas"
  extends Interfaces.Thermometer(T(start=T_start, fixed=true));
  extends Interfaces.Effect(final family="thermocouple_lag", final balance="sensor", final absent="tau=1e-3, n=0");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant at ambient pressure";
  parameter Real n(unit="1", min=-0.5, max=1, nominal=0.3) = 0.3 "Exponent of the pressure in the heat exchange of the bead";
protected
  outer Components.Ambient ambient "Surroundings";
equation
  tau*der(T) = (port.T - T)*exp(n*log(max(port.p, 1.0)/ambient.p));
  annotation (Documentation(info="<html>
<p>tau T_dot = (p/p_atm)^n (T_gas - T). Source: heat balance of a small bead, Nu ~ Re^n with the density in Re: n = 0.5
in a stream across a wire, 0.25 to 0.5 in free convection, 0 in gas at rest. Typical tau as for ThermocoupleLag.</p>
<p>Fingerprint: as ThermocoupleLag, later in venting than in filling.</p>
</html>"));
end FlexibleThermocouple;
