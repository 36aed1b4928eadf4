within PneumaticMuscle;
package Constants "Constants of air, of the earth and of the valves of DP"
  extends Icons.Package;
  constant Types.SpecificHeatCapacity R = 287.05 "Specific gas constant of air";
  constant Real gamma(unit="1") = 1.4 "Ratio of specific heats, DP Table 1";
  constant Types.SpecificHeatCapacity cp = gamma*R/(gamma - 1) "Specific heat capacity at constant pressure, DP (23)";
  constant Types.SpecificHeatCapacity cv = R/(gamma - 1) "Specific heat capacity at constant volume, DP (23)";
  constant Types.Acceleration g = 9.80665 "Standard gravity";
  constant Real k_open(unit="m2/A") = 1.80e-6 "Effective area of a valve by its current, DP (62)";
  constant Types.Area A_shut = 2.61e-7 "Area by which a valve without current is short of opening, DP (62)";
  constant Real pi(unit="1") = 3.14159265358979 "Ratio of a circle's circumference to its diameter";
  annotation (Documentation(info="<html>
<p>R = 287.05 J/(kg.K), gamma = 1.4 (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 1), c_p
and c_v by DP (23), standard gravity, and the effective area of a valve as DP (62) has it,
A = max(0, k_open u - A_shut).</p>
</html>"));
end Constants;
