within PneumaticMuscle.Laws.Forces;
model Sarosi "Exponential and linear in contraction, linear in pressure, six coefficients"
  extends Interfaces.PullingSleeve;
  parameter Types.Area a_1(min=-0.1, max=0.1, nominal=1e-4) = -4.35573e-5 "Coefficient of the exponential per pressure"
    annotation (Dialog(group="Law"));
  parameter Types.Force a_2(min=-1e4, max=1e4, nominal=100) = 281.2237 "Coefficient of the exponential"
    annotation (Dialog(group="Law"));
  parameter Real a_3(unit="1", min=-200, max=0, nominal=10) = -32.866 "Its exponent per contraction ratio"
    annotation (Dialog(group="Law"));
  parameter Types.Area a_4(min=-1, max=1, nominal=1e-3) = -9.27035e-3 "Coefficient of pressure times contraction ratio"
    annotation (Dialog(group="Law"));
  parameter Types.Area a_5(min=-0.1, max=0.1, nominal=1e-3) = 3.0220107e-3 "Coefficient of pressure"
    annotation (Dialog(group="Law"));
  parameter Types.Force a_6(min=-1e4, max=1e4, nominal=100) = -263.69185 "Constant force"
    annotation (Dialog(group="Law"));
equation
  F_law = (a_1*p_gauge + a_2)*exp(a_3*eps) + a_4*p_gauge*eps + a_5*p_gauge + a_6;
  annotation (Documentation(info="<html>
<p>F = (a_1 p + a_2) exp(a_3 eps) + a_4 p eps + a_5 p + a_6,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sarosi 2012</a>, who takes p in bar and eps in percent. Not
below zero here. The original was not at hand; formula and coefficients are those that
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others 2026</a> compare with, in these units,
N:</p>
<table>
<tr><th>muscle</th><th>a_1</th><th>a_2</th><th>a_3</th><th>a_4</th><th>a_5</th><th>a_6</th></tr>
<tr><td>DMSP-20, 400 mm (default)</td>
<td>-4.35573</td><td>281.22370</td><td>-0.32866</td>
<td>-9.27035</td><td>302.20107</td><td>-263.69185</td></tr>
<tr><td>DMSP-20, 200 mm</td>
<td>-4.00180705</td><td>292.4620246</td><td>-0.32930845</td>
<td>-9.33564098</td><td>294.0538256</td><td>-280.498151</td></tr>
<tr><td>10 mm, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sarosi and Fabulya
2012</a></td>
<td>-9.2194029</td><td>203.7012413</td><td>-0.34221042</td>
<td>-3.2255991</td><td>109.2038216</td><td>-208.372034</td></tr>
</table>
<p>They hold for the muscle that they were fitted to: for muscles of other lengths Bolen and others 2026 find 130 to 180
N rms.</p>
</html>"));
end Sarosi;
