within PneumaticMuscle.Effects;
model ThermocoupleLag "The temperature reading lags"
  extends Interfaces.Thermometer(T(start=T_start, fixed=true));
  extends Interfaces.Effect(final family="thermocouple_lag", final balance="sensor");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant";
equation
  tau*der(T) = port.T - T;
  annotation (Documentation(info="<html>
<p>tau T_dot = T_gas - T.</p>
<p>Fingerprint: the temperature is smooth and late; pressure and contraction are right.</p>
</html>"));
end ThermocoupleLag;
