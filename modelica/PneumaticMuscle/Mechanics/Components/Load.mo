within PneumaticMuscle.Mechanics.Components;
model Load "A hanging mass"
  extends SlidingMass(m=2.27);
  extends Icons.Load;
equation
  f_back = m*Constants.g;
  annotation (Documentation(info="<html>
<p>m x_ddot = F - m g, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (16)-(18), positive
upwards.</p>
</html>"));
end Load;
