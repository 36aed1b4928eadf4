within PneumaticMuscle.Laws.Forces;
model ThreeElementShape "Two frustums and a cylinder, DP (13), by virtual work"
  extends Interfaces.Braid;
  parameter Types.Length d(min=1e-3, max=0.2) = 0.013 "Diameter of the end connectors, DP Table 1"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length L_z(min=1e-3, max=0.1) = 0.008 "Length of a generator of the cones, DP Table 1"
    annotation (Dialog(group="Geometry"));
  Types.Length L_L "Length of a frustum along the axis";
  Types.Length margin = L_z - (D - d)/2
    "What the generator is longer than the step it must span; below zero the shape does not exist";
protected
  constant Real rounding(unit="1") = 0.02 "Part of L_z^2 over which L_L^2 is kept off zero";
  Real a(unit="m2") = L_z^2 - (D - d)^2/4 "Square of L_L where the shape exists";
  Real a_D(unit="m") = -(D - d)/2 "da/dD";
  Real L_L_D(unit="1") "dL_L/dD";
  Real D_L(unit="1") = -L/((turns*Constants.pi)^2*D) "dD/dL";
  Real V_D(unit="m2") "Slope of the volume by diameter at one length";
equation
  assert(margin > 0,
    "the three-element shape of DP (13) exists only while (D - d)/2 < L_z: the muscle is so thick that "
    + "the cones cannot span the step from the connectors; contract less or use Laws.Forces.CylindricalBraid");
  D = sqrt(max(b^2 - L^2, 1e-8))/(turns*Constants.pi);
  L_L = sqrt(Functions.smoothMax(a, rounding*L_z^2));
  L_L_D = a_D*0.5*(1 + a/sqrt(a^2 + (rounding*L_z^2)^2))/(2*L_L);
  V = Constants.pi*(L_L*(D^2 + d^2 + d*D)/6 + D^2*(L - 2*L_L)/4);
  V_D = Constants.pi*(L_L_D*(D^2 + d^2 + d*D)/6 + L_L*(2*D + d)/6 + D*(L - 2*L_L)/2 - D^2*L_L_D/2);
  F = -(port.p - ambient.p)*(V_D*D_L + Constants.pi*D^2/4);
  annotation (Documentation(info="<html>
<p>V = 2/3 pi L_L ((D/2)^2 + (d/2)^2 + d D/4) + pi (D/2)^2 (L - 2 L_L),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (13), with L_L^2 = L_z^2 - ((D - d)/2)^2 (DP Fig. 3)
and the diameter that the fibres give a cylinder of this length, D = sqrt(b^2 - L^2)/(n pi). The force is virtual work
on that volume, F = -p_gauge dV/dL; the tensions DP (14)-(15) come from a reference that is not given.</p>
<p>The shape exists only while (D - d)/2 &lt; L_z: up to D = 29 mm, 39 mm of contraction, for DP Table 1, although the
same table's muscle contracts by 68 mm at 207 kPa. Beyond that L_L is kept off zero, so that every expression stays
finite, but the results have no meaning: a run ends where <code>margin</code> is no longer positive, with a message
that says so.</p>
</html>"));
end ThreeElementShape;
