within PneumaticMuscle.Laws.Forces;
model Wickramatunge "A spring whose stiffness depends on pressure and stretch"
  extends Interfaces.PullingSleeve;
  parameter Types.TranslationalStiffness c_0(min=-1e6, max=1e6, nominal=1e4) = -6099 "Stiffness"
    annotation (Dialog(group="Law"));
  parameter Real c_1(unit="N/m3", min=-1e9, max=1e9, nominal=1e6) = 220200 "By the square of the stretch"
    annotation (Dialog(group="Law"));
  parameter Real c_2(unit="1", min=-10, max=10, nominal=0.1) = 0.11464 "By pressure times stretch"
    annotation (Dialog(group="Law"));
  parameter Real c_3(unit="N/(m.Pa2)", min=-1e-5, max=1e-5, nominal=1e-9) = -5.166e-10 "By the square of the pressure"
    annotation (Dialog(group="Law"));
  parameter Real eps_s(unit="1", min=0.05, max=1) = 0.5173 "Contraction ratio at which the spring has no stretch"
    annotation (Dialog(group="Law"));
  Types.Length L_s = L - (1 - eps_s)*L0 "Stretch";
equation
  F_law = L_s*(c_0 + c_1*L_s^2 + c_2*p_gauge*L_s + c_3*p_gauge^2);
  annotation (Documentation(info="<html>
<p>F = K L_s, K = c_3 p^2 + c_2 p L_s + c_1 L_s^2 + c_0:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Wickramatunge and Leephakpreeda 2010</a>, a spring with a
stiffness that is a polynomial of second order in pressure and length, as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 1 describes it. The paper was not at hand;
from where it counts the stretch is a parameter here, eps_s. Defaults: fitted to Table A1 of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, of which it leaves 26 N rms of
1654 N: of the laws for fluidic muscles in this package the farthest off. Not below zero here.</p>
</html>"));
end Wickramatunge;
