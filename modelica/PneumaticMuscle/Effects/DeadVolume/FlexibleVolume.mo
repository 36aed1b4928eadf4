within PneumaticMuscle.Effects.DeadVolume;
model FlexibleVolume "Gas that takes no part in contraction, in a space that grows with pressure"
  extends FamilyMember(final absent="V_0=0, V_p=0");
  parameter Types.Volume V_0(min=0, max=1e-3, nominal=1e-5) = 1e-5 "Volume at ambient pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Volume V_p(min=0, max=1e-3, nominal=1e-5) = 2e-6 "Increase per 100 kPa"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="DeadVolume"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which V_p is added";
  Types.Volume V = V_0 + V_p*(port.p - ambient.p)/p_reference "Volume";
  Types.Mass m(nominal=1e-5) = port.p*V/(Constants.R*port.T) "Mass of the gas in it";
equation
  port.m_flow = der(m);
  port.H_flow = (V + Constants.gamma*port.p*V_p/p_reference)/(Constants.gamma - 1)*der(port.p);
  annotation (defaultComponentName="deadVolume", Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume.DeadVolume\">DeadVolume</a>, V = V_0 + V_p p_gauge/100
kPa; the enthalpy that flows in is the internal energy gained and the work done, p dV. Source: the balances
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43) and (59); a hose stretches in proportion to
pressure as long as it is elastic. Typical 1 to 30 mL for a muscle, V_p a tenth of V_0 for a rubber hose.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DeadVolume.DeadVolume\">DeadVolume</a>, slower towards
the end of filling.</p>
</html>"));
end FlexibleVolume;
