within PneumaticMuscle.Effects.ValveArea;
model CurrentOffsetArea "The valves open at another current than calibrated"
  extends Interfaces.ValveArea;
  extends FamilyMember(final absent="u_0=0");
  parameter Types.Current u_0(min=-0.14, max=0.14, nominal=0.01) = 0.01
    "Offset of the current"
    annotation (Dialog(group="Effect"));
equation
  for i in 1:2 loop
    A[i] = C_A*Functions.openingArea(u[i] + u_0);
  end for;
  annotation (Documentation(info="<html>
<p>A = C_A max(0, 1.80e-6 (u + u_0) - 2.61e-7). Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62) with an offset: threshold and hysteresis of
proportional valves are given as some percent of the full current. Typical 5 to 30 mA; the bound keeps the valves shut
without current.</p>
<p>Fingerprint: the flow is wrong by another factor at every current, most at small currents; at one current
alone it cannot be told from C_A.</p>
</html>"));
end CurrentOffsetArea;
