within PneumaticMuscle.Interfaces;
partial model Cylinder "A sleeve that is a cylinder at any contraction"
  extends Braid;
equation
  D = sqrt(max(b^2 - L^2, 1e-8))/(turns*Constants.pi);
  V = L*(b^2 - L^2)/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>D = sqrt(b^2 - L^2)/(n pi), V = L (b^2 - L^2)/(4 pi n^2). Left to the extending class: F.</p>
</html>"));
end Cylinder;
