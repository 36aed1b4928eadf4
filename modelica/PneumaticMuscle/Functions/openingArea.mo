within PneumaticMuscle.Functions;
function openingArea "Effective area of a valve by its current, uncalibrated, DP (62)"
  extends Icons.Function;
  input Types.Current u "Current";
  output Types.Area A "Effective area";
algorithm
  A := max(0, Constants.k_open*u - Constants.A_shut);
  annotation (Documentation(info="<html>
<p>A(u) = max(0, 1.80e-6 u - 2.61e-7) m2, u in A, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(62).</p>
</html>"));
end openingArea;
