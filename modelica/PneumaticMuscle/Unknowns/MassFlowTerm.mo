within PneumaticMuscle.Unknowns;
partial model MassFlowTerm "A further mass flow into the gas"
  extends Interfaces.GasPortEffect;
  extends Icons.Unknown;
  Types.MassFlowRate missing "Mass flow, positive into the gas";
  Types.GaugePressure p_gauge "Gauge pressure";
  Real p_rate(unit="Pa/s") "Rate of the pressure";
equation
  p_gauge = port.p - ambient.p;
  p_rate = der(port.p);
  port.m_flow = -missing;
  port.H_flow = -missing*Constants.cp*port.T;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of <code>missing</code>. The gas comes and goes with the temperature of
the gas that is there. A law of the gas that asks for the enthalpy flow alone, such as
<a href=\"modelica://PneumaticMuscle.Laws.Gases.PolytropicMuscleGas\">Laws.Gases.PolytropicMuscleGas</a>, cannot tell it
from a heat flow of c_p T m_flow.</p>
</html>"));
end MassFlowTerm;
