within PneumaticMuscle.Effects.ThermocoupleLag;
model FlexibleThermocouple
  "The temperature reading lags, less in dense or flowing gas, and loses heat to the surroundings"
  extends Interfaces.Thermometer(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="tau=1e-3, n=0, b=0, loss=0");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant in gas at rest at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=-0.5, max=1, nominal=0.3) = 0.3
    "Exponent of the pressure in the heat exchange of the bead"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=0, max=50, nominal=1) = 0.3
    "Relative increase of the heat exchange at the reference flow"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-1, max=1, nominal=0.3) = 0 "Relative asymmetry between filling and venting"
    annotation (Dialog(group="Effect"));
  parameter Real loss(unit="1", min=0, max=2, nominal=0.03) = 0.02
    "Ratio of the conductance to ambient to that to gas at rest"
    annotation (Dialog(group="Effect"));
protected
  constant Types.MassFlowRate m_reference = 1e-4 "Flow at which b is added";
  constant Types.MassFlowRate m_smooth = 1e-7 "Flow over which filling and venting change roles";
  Real r(unit="1") = m_flow/m_reference "Flow by the reference";
  Real flow_size(unit="1") = sqrt(r^2 + (m_smooth/m_reference)^2) "Its size";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
  end if;
equation
  tau*der(T) = (port.T - T)*(exp(n*log(max(port.p, 1.0)/ambient.p)) + b*sqrt(flow_size)*(1 + asymmetry*r/flow_size))
    - loss*(T - ambient.T);
  annotation (Documentation(info="<html>
<p>tau T_dot = ((p/p_atm)^n + b (1 + asymmetry sgn m_flow) (|m_flow|/0.1 g/s)^0.5) (T_gas - T) - loss (T - T_atm).
Source:
heat balance of a small bead; the law of a wire in a stream, Nu = A + B Re^0.5,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">King 1914</a>, where a jet that fills may hit the bead and
one that vents need not (asymmetry); in A the density, by an exponent of 0.25 to 0.5 in free convection and 0 in gas at
rest;
radiation and stem conduction as a conductance to what stays at ambient temperature
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Scadron and Warshawsky 1952</a>). Beads that follow
another power of the flow (0.6), that the pressure multiplies, or that only filling blows at, are met within 3 % of what
they change in the reading. Typical tau as for
<a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleLag\">ThermocoupleLag</a>, b 0 to 5, loss 0 to
0.1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleLag\">ThermocoupleLag</a>,
later in holds than while gas flows, and later in venting than in filling; with losses the reading stops short of the
gas temperature.</p>
</html>"));
end FlexibleThermocouple;
