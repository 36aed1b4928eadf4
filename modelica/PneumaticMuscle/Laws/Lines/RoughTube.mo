within PneumaticMuscle.Laws.Lines;
model RoughTube "A tube with isothermal flow, laminar where it is small and turbulent where it is large"
  extends Interfaces.TwoGasPorts;
  extends Icons.Line;
  parameter Real G(unit="kg/(s.Pa)") "Conductance of small flows at ambient pressure" annotation (Dialog(group="Flow"));
  parameter Types.Area A "Effective area for large flows" annotation (Dialog(group="Flow"));
  outer Ambient ambient "Surroundings";
protected
  constant Types.Pressure p_smooth = 10 "Pressure drop at ambient pressure below which its size is rounded";
  Real drop(unit="Pa2") = port_a.p^2 - port_b.p^2 "Drop of the square of pressure";
  Real laminar(unit="Pa2.s/kg") = 2*ambient.p/G "Resistance of small flows";
equation
  m_flow = 2*drop/(laminar + sqrt(laminar^2
    + 4*Constants.R*T_up/A^2*sqrt(drop^2 + (2*ambient.p*p_smooth)^2)));
  annotation (Documentation(info="<html>
<p>p_a^2 - p_b^2 = 2 p_atm/G m_flow + R T/A^2 m_flow |m_flow|, the law of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Forchheimer 1901</a> for the isothermal flow of an ideal
gas; solved for m_flow, the size of the left side rounded below 10 Pa of pressure drop.</p>
</html>"));
end RoughTube;
