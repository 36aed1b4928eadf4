within PneumaticMuscle.Effects.ThermocoupleLag;
model ThermocoupleStem "The temperature reading lags and is drawn to the temperature of a stem that lags more"
  extends Interfaces.Thermometer(T(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="tau=1e-3, stem=0");
  parameter Types.Time tau(min=1e-3, max=100, nominal=1) = 1 "Time constant without the stem"
    annotation (Dialog(group="Effect"));
  parameter Real stem(unit="1", min=0, max=10, nominal=0.1) = 0.1
    "Ratio of the conductance to the stem to that to the gas"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="ThermocoupleLag"));
  parameter Types.Time tau_stem(min=0.01, max=1e3, nominal=1) = 5 "Time constant of the stem"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="ThermocoupleLag"));
  Types.Temperature T_stem(start=T_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Temperature of the stem";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T) = 0;
    der(T_stem) = 0;
  end if;
equation
  tau*der(T) = port.T - T - stem*(T - T_stem);
  tau_stem*der(T_stem) = port.T - T_stem;
  annotation (Documentation(info="<html>
<p>tau T_dot = T_gas - T - stem (T - T_stem), tau_stem T_stem_dot = T_gas - T_stem. Source: heat balance of a bead
between gas and the wires or the sheath that hold it
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Scadron and Warshawsky 1952</a>): any two time constants,
and any quick share of the reading from 1/11 on; a stem that never follows keeps a share of the reading at the start.
Two shares of the reading that follow in their own time are met exactly, a sheath and a junction in series within 1 %.
Typical tau as for <a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleLag\">ThermocoupleLag</a>,
stem 0.02 to 1, tau_stem 1 to 100 s.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleLag\">ThermocoupleLag</a>,
but the reading comes near fast and then creeps.</p>
</html>"));
end ThermocoupleStem;
