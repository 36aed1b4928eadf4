within PneumaticMuscle.Effects.EndShape;
model KerscherEnds "The slenderness of the muscle changes the force, the more so the less it is contracted"
  extends Interfaces.Cylinder;
  extends FamilyMember(final absent="c_3=0");
  parameter Real c_3(unit="1", min=-0.5, max=1, nominal=0.1) = 0.1 "Excess of the force at full length"
    annotation (Dialog(group="Effect"));
  parameter Real eps_0(unit="1", min=0.01, max=1, nominal=0.1) = 0.1 "Strain of decay to 1/e"
    annotation (Dialog(group="Effect"));
equation
  F = (1 + c_3*exp(-(L0 - L)/L0/eps_0))*(port.p - ambient.p)*(3*L^2 - b^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>F = mu(eps) F_s, mu = c_3 exp(c_4 eps) + c_5, with c_4 = -1/eps_0. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Kerscher and others 2006</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (5) and (7). c_5 = 1: a factor that stays at large
contraction cannot be told from the diameter. Typical c_3 -0.2 to 0.5, eps_0 0.03 to 0.3. The volume keeps the
cylinder's law.</p>
<p>Fingerprint: lift-off happens at another pressure and the first part of the contraction is wrong; the last
part is right.</p>
</html>"));
end KerscherEnds;
