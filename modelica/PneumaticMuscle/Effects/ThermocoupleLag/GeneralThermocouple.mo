within PneumaticMuscle.Effects.ThermocoupleLag;
model GeneralThermocouple
  "The temperature reading lags by any law of pressure and flow, "
  + "behind a sheath, and is drawn to a stem and to the surroundings"
  extends Interfaces.Thermometer(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final general=true,
    final absent="tau=1e-3, n=0, b=0, loss=0, stem=0, r=1e-3");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant in gas at rest at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=-0.5, max=1, nominal=0.3) = 0.3
    "Exponent of the pressure in the heat exchange of the bead"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=0, max=50, nominal=1) = 0.3
    "Relative increase of the heat exchange at the reference flow"
    annotation (Dialog(group="Effect"));
  parameter Real n_m(unit="1", min=0.2, max=1.2, nominal=0.5) = 0.5 "Exponent of the flow"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-1, max=1, nominal=0.3) = 0 "Relative asymmetry between filling and venting"
    annotation (Dialog(group="Effect"));
  parameter Real loss(unit="1", min=0, max=2, nominal=0.03) = 0.02
    "Ratio of the conductance to ambient to that to gas at rest"
    annotation (Dialog(group="Effect"));
  parameter Real stem(unit="1", min=0, max=10, nominal=0.1) = 0.03
    "Ratio of the conductance to the stem to that to gas at rest"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau_stem(min=0.01, max=1e3, nominal=1) = 5 "Time constant of the stem"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=1e-3, max=1, nominal=0.1) = 0.03 "Ratio of the time constants of junction and sheath"
    annotation (Dialog(group="Effect"));
  Types.Temperature T_s(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Temperature of the sheath";
  Types.Temperature T_stem(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Temperature of the stem";
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow at which b is added";
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow over which filling and venting change roles";
  Real m(unit="1") = m_flow/m_reference "Flow by the reference";
  Real flow_size(unit="1") = sqrt(m^2 + (m_smooth/m_reference)^2) "Its size";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
    der(T_s) = 0;
    der(T_stem) = 0;
  end if;
equation
  tau*der(T_s) = (port.T - T_s)*(exp(n*log(max(port.p, 1.0)/ambient.p))
    + b*exp(n_m*log(flow_size))*(1 + asymmetry*m/flow_size))
    - loss*(T_s - ambient.T) - stem*(T_s - T_stem);
  r*tau*der(T) = T_s - T;
  tau_stem*der(T_stem) = port.T - T_stem;
  annotation (Documentation(info="<html>
<p>tau T_s_dot = ((p/p_atm)^n + b (1 + asymmetry sgn m_flow) (|m_flow|/0.1 g/s)^n_m) (T_gas - T_s) - loss (T_s - T_atm)
-
stem (T_s - T_stem), tau_stem T_stem_dot = T_gas - T_stem, r tau T_dot = T_s - T. Source:
<a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.FlexibleThermocouple\">FlexibleThermocouple</a>,
<a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleStem\">ThermocoupleStem</a> and
<a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleSheath\">ThermocoupleSheath</a>, see there, in
one, with a free exponent of the flow. Typical as there.</p>
<p>Fingerprint: as those.</p>
</html>"));
end GeneralThermocouple;
