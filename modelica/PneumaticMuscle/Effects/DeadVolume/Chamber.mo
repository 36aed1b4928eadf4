within PneumaticMuscle.Effects.DeadVolume;
partial model Chamber "A rigid space behind an opening that takes the heat of its gas"
  extends FamilyMember;
  parameter Types.Volume V(min=1e-7, max=1e-3, nominal=1e-5) = 1e-5 "Volume"
    annotation (Dialog(group="Effect"), __PamCosim(at_min=""));
  parameter Real G(unit="kg/(s.Pa)", min=1e-11, max=1e-7, nominal=1e-9) = 2e-9
    "Conductance of the opening at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance UA(min=0, max=50, nominal=0.02) = 0.02
    "Thermal conductance from the gas to ambient"
    annotation (Dialog(group="Effect"));
  Types.AbsolutePressure p_s(start=ambient.p) "Pressure in it";
  Types.Temperature T_s(start=ambient.T) "Temperature in it";
  Types.Mass m(nominal=1e-5) "Mass of the gas in it";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    p_s = port.p;
    T_s = port.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(p_s) = 0;
    der(m) = 0;
  end if;
equation
  der(m) = port.m_flow;
  p_s*V = m*Constants.R*T_s;
  V*der(p_s) = (Constants.gamma - 1)*(port.H_flow - UA*(T_s - ambient.T));
  annotation (Documentation(info="<html>
<p>p_s V = m R T_s, V p_s_dot = (gamma - 1) (H_flow - UA (T_s - T_atm)). Source: the balances
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53) and (59) of a rigid space. Left to the
extending class: port.m_flow and port.H_flow.</p>
</html>"));
end Chamber;
