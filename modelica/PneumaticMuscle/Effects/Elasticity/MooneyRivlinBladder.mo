within PneumaticMuscle.Effects.Elasticity;
model MooneyRivlinBladder "The bladder is a thin Mooney-Rivlin tube that follows the sleeve"
  extends FamilyMember(final absent="C_10=0, C_01=0");
  parameter Types.Pressure C_10(min=0, max=1e7, nominal=1e5) = 1.5e5 "First coefficient"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure C_01(min=0, max=1e6, nominal=1e4) = 1e4 "Second coefficient"
    annotation (Dialog(group="Effect"));
protected
  final parameter Real b2(unit="m2") = L0^2 + (turns*Constants.pi*D0)^2 "Square of the length of a fibre";
  final parameter Types.Volume V_wall = Constants.pi*D0*t_wall*L0 "Volume of the rubber";
  Types.Length L = L0 - x "Length";
  Real a(unit="1") = (L/L0)^2 "Square of the axial stretch";
  Real h(unit="1") = (b2 - L^2)/(turns*Constants.pi*D0)^2 "Square of the hoop stretch";
  Real a_L(unit="1/m") = 2*L/L0^2 "da/dL";
  Real h_L(unit="1/m") = -2*L/(turns*Constants.pi*D0)^2 "dh/dL";
  Real I1_L(unit="1/m") = a_L + h_L - (a_L/a + h_L/h)/(a*h) "Slope of the first invariant, a + h + 1/(a h)";
  Real I2_L(unit="1/m") = -a_L/a^2 - h_L/h^2 + a_L*h + a*h_L "Slope of the second invariant, 1/a + 1/h + a h";
equation
  f = -V_wall*(C_10*I1_L + C_01*I2_L);
  annotation (defaultComponentName="bladder", Documentation(info="<html>
<p>Virtual work f = -dU/dL of U = V_wall (C_10 (I1 - 3) + C_01 (I2 - 3)) for an incompressible thin wall with
the stretches of the sleeve, L/L0 along and D/D0 around. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Wang, Wereley and Pillsbury 2015</a>, discussed after
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12). Typical for soft rubber: C_10 0.05 to 0.5 MPa,
C_01 a tenth of that.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Elasticity.YoungBladder\">YoungBladder</a>, with the
curve of real rubber: stiff at first, softer, stiff again. C_01 is known only from large contractions.</p>
</html>"));
end MooneyRivlinBladder;
