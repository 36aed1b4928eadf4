within PneumaticMuscle.Laws.Forces;
model CylindricalBraid "A cylinder at any contraction; force by virtual work, DP (1)"
  extends Interfaces.Cylinder;
equation
  F = (port.p - ambient.p)*(3*L^2 - b^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>F = -p_gauge dV/dL = p_gauge (3 L^2 - b^2)/(4 pi n^2): Gaylord's force,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1). DP (14)-(15) need fibre tensions from a
reference that does not give them; virtual work on the same geometry is equivalent.</p>
</html>"));
end CylindricalBraid;
