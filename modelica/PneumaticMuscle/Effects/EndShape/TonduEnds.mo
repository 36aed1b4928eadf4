within PneumaticMuscle.Effects.EndShape;
model TonduEnds "The ends contract less than the middle: strain counts k times in the force"
  extends Interfaces.Cylinder;
  extends FamilyMember(final absent="k=1");
  parameter Real k(unit="1", min=0.8, max=1.6, nominal=1) = 1.05 "Factor on the strain"
    annotation (Dialog(group="Effect"));
protected
  Types.Length L_e = L0 - k*(L0 - L) "Length that counts in the force";
equation
  F = (port.p - ambient.p)*(3*L_e^2 - b^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>F = pi D0^2 p/4 (3 (1 - k eps)^2/tan(alpha)^2 - 1/sin(alpha)^2), which is
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1) at the length L0 (1 - k eps). Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Tondu, Boitier and Lopez 1994</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (1)-(2). Typical 1.0 to 1.35; with k the shortest
length is reached at 1/k of the strain. Fittings of length l that count in L0 and do not contract are k = L0/(L0 - l).
The volume keeps the cylinder's law.</p>
<p>Fingerprint: the contraction falls short in proportion to itself at any load and pressure; the length at rest
is wrong, whichever way it was reached, and the pressure hardly changes. A bladder is the stronger the lower the
pressure is.</p>
</html>"));
end TonduEnds;
