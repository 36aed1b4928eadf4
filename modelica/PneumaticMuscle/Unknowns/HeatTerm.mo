within PneumaticMuscle.Unknowns;
partial model HeatTerm "A further heat flow into the gas"
  extends Interfaces.VesselTerminals;
  extends Interfaces.Effect(final balance="energy");
  extends Icons.Unknown;
  Types.Power missing "Heat flow, positive into the gas";
  Types.GaugePressure p_gauge "Gauge pressure";
  Real T_excess(unit="K") "Temperature of the gas above that of the surroundings";
  outer Ambient ambient "Surroundings";
equation
  p_gauge = port.p - ambient.p;
  T_excess = port.T - ambient.T;
  port.m_flow = 0;
  port.H_flow = -missing;
  annotation (Documentation(info="<html>
<p>Energy without mass. Left to the extending class: the equation of <code>missing</code>. A law of the gas whose
exponent stands for the heat, such as
<a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicVesselGas\">Laws.Gases.PolytropicVesselGas</a>, does not feel
it.</p>
</html>"));
end HeatTerm;
