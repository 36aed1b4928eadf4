within PneumaticMuscle.Effects.ThermocoupleLag;
model ThermocoupleSheath "The temperature reading lags behind a sheath that lags behind the gas"
  extends Interfaces.Thermometer(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="tau=1e-3");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant of the sheath"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=0.02, max=1, nominal=1) = 0.3 "Ratio of the time constants of junction and sheath"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="ThermocoupleLag"));
  Types.Temperature T_s(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Temperature of the sheath";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
    der(T_s) = 0;
  end if;
equation
  tau*der(T_s) = port.T - T_s;
  r*tau*der(T) = T_s - T;
  annotation (Documentation(info="<html>
<p>tau T_s_dot = T_gas - T_s, r tau T_dot = T_s - T. Source: sheath and junction as two stores of heat in series
(thermowell; sensors of two poles, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Kerlin, Miller and
Hashemian 1978</a>). Only the slower one may be the sheath: exchanging the two changes nothing. Typical 0.5 to 20 s,
0.05 to 0.5.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleLag\">ThermocoupleLag</a>,
with a soft beginning after each step.</p>
</html>"));
end ThermocoupleSheath;
