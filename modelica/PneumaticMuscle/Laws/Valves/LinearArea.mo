within PneumaticMuscle.Laws.Valves;
model LinearArea "Effective area linear in the current above a threshold, DP (62)"
  extends Interfaces.ValveArea;
equation
  for i in 1:2 loop
    A[i] = C_A*Functions.openingArea(u[i]);
  end for;
  annotation (Documentation(info="<html>
<p>A = C_A max(0, 1.80e-6 u - 2.61e-7) m2 for either valve,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62).</p>
</html>"));
end LinearArea;
