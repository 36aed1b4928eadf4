within PneumaticMuscle.Effects.Elasticity;
model YoungBladder "The bladder is a thin tube of Hooke's rubber that follows the sleeve"
  extends FamilyMember(final absent="E=0");
  parameter Types.Pressure E(min=0, max=5e7, nominal=1e6) = 1e6 "Modulus of elasticity of the rubber"
    annotation (Dialog(group="Effect"));
protected
  final parameter Types.Length b = sqrt(L0^2 + (turns*Constants.pi*D0)^2) "Length of a fibre";
  final parameter Types.Volume V_wall = Constants.pi*D0*t_wall*L0 "Volume of the rubber";
  Types.Length L = L0 - x "Length";
  Types.Length D = sqrt(max(b^2 - L^2, 1e-8))/(turns*Constants.pi) "Diameter";
  Real e_a(unit="1") = L/L0 - 1 "Axial strain";
  Real e_h(unit="1") = D/D0 - 1 "Hoop strain";
equation
  f = 2/3*E*V_wall*(-(2*e_a + e_h)/L0 + (2*e_h + e_a)*L/((turns*Constants.pi)^2*D*D0));
  annotation (defaultComponentName="bladder", Documentation(info="<html>
<p>Virtual work f = dU/dx of the strain energy U = 2/3 E V_wall (e_a^2 + e_a e_h + e_h^2): plane stress,
Poisson's ratio 1/2, axial strain e_a = L/L0 - 1, hoop strain e_h = D/D0 - 1, with the diameter of the sleeve.
Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Ferraresi, Franco and Bertetto 2001</a>, discussed
after <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12). Typical 0.5 to 5 MPa: latex 1, butyl
rubber 2; the bound, 50 MPa, is a hard rubber.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Elasticity.LinearBladder\">LinearBladder</a>; the force
follows the diameter more than the length, so it rises faster than the contraction.</p>
</html>"));
end YoungBladder;
