within PneumaticMuscle.Effects.Leak;
model OrificeLeak "Gas escapes through a small hole"
  extends FamilyMember(final absent="A=0");
  parameter Types.Area A(min=0, max=2.5e-7, nominal=5e-9) = 5e-9 "Effective area of the hole"
    annotation (Dialog(group="Effect"));
equation
  port.m_flow = Functions.isentropicFlow(port.p, ambient.p,
    Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T), A);
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>Isentropic flow to the surroundings. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(40)-(42). Typical 1e-9 to 5e-8 m2; 2.5e-7 is an open valve of DP.</p>
<p>Fingerprint: the pressure falls while both valves are shut, fills more slowly and settles below the
supply.</p>
</html>"));
end OrificeLeak;
