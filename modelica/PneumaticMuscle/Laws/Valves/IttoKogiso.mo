within PneumaticMuscle.Laws.Valves;
model IttoKogiso "One proportional valve shares its opening between inlet and outlet, DP (8)"
  extends Interfaces.ValveArea;
  parameter Types.Area A_0(min=1e-9, max=1e-4, nominal=1e-7) = 3.69e-7
    "Area of the fully opened valve before calibration"
    annotation (Dialog(group="Law"));
  parameter Types.Current u_full(min=1e-3, max=10) = 0.35
    "Command at which only the inlet is open; at zero only the outlet is"
    annotation (Dialog(group="Law"));
  Real phi(unit="1") = max(0, min(1, u[1]/u_full)) "Share of the inlet, from 0 to 1";
equation
  A[1] = C_A*A_0*phi;
  A[2] = C_A*A_0*(1 - phi);
  annotation (Documentation(info="<html>
<p>m = phi m_i - (1 - phi) m_o with phi from 0 to 1 by the command,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (8),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Itto and Kogiso 2011</a>. The first command drives the one
valve; the second has no effect. A command between its ends holds a pressure with gas flowing through: the net flow
vanishes in the steady state, as the paper asks. A_0 is DP (62) at 0.35 A.</p>
</html>"));
end IttoKogiso;
