within PneumaticMuscle.Laws.Forces;
model TothovaPitel "A barrel: the diameter varies along the muscle, DP (9)"
  extends Interfaces.Braid;
  parameter Types.Length d_1(min=1e-3, max=0.2) = 0.013 "Diameter at the ends; that of the valve in DP"
    annotation (Dialog(group="Geometry"));
protected
  Real N_pi(unit="1") = turns*Constants.pi "Half a circle by turns";
equation
  D = sqrt(max(b^2 - L^2, 1e-8))/N_pi;
  V = Constants.pi*L/60*(8*D^2 + 4*D*d_1 + 3*d_1^2);
  F = -(port.p - ambient.p)*(Constants.pi*d_1^2/20 + (2*b^2 - 6*L^2)/(15*Constants.pi*turns^2)
    + d_1*N_pi*D/(15*turns) - d_1*L^2/(15*turns*N_pi*D));
  annotation (Documentation(info="<html>
<p>F = -p dV/dh = -p (pi d_1^2/20 + (8 L^2 - 6 h^2)/(15 pi N^2) + d_1 sqrt(4 L^2 - h^2)/(15 N)
- d_1 h^2/(15 N sqrt(4 L^2 - h^2))), <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (9); L there is
half the length of a fibre, b = 2 L, and h the length of the muscle, L here. It is the derivative of the volume of a
barrel with parabolic staves, V = pi h/60 (8 D^2 + 4 D d_1 + 3 d_1^2), with D = sqrt(b^2 - h^2)/(pi N) in the middle, by
differentiation. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Tothova and Pitel 2013</a>.
Factors and plus signs of the print agree with it; minus signs are lost in the text of DP that was at hand, so that they
rest on the derivation.</p>
</html>"));
end TothovaPitel;
