within PneumaticMuscle.Functions;
function openingCurrent "Current that opens a valve by an effective area, uncalibrated, DP (62)"
  extends Icons.Function;
  input Types.Area A "Effective area";
  output Types.Current u "Current";
algorithm
  u := (A + Constants.A_shut)/Constants.k_open;
  annotation (Documentation(info="<html>
<p>u = (A + 2.61e-7 m2)/(1.80e-6 m2/A), the inverse of
<a href=\"modelica://PneumaticMuscle.Functions.openingArea\">openingArea</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62).</p>
</html>"));
end openingCurrent;
