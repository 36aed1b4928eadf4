within PneumaticMuscle.Laws.Heat;
model StillAir "Surroundings that take any heat without getting warmer"
  extends Interfaces.Surroundings;
equation
  heatPort.T = ambient.T;
  annotation (Documentation(info="<html>
<p>The outer side of the wall has the ambient temperature: an infinite store of heat, as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (44) has it.</p>
</html>"));
end StillAir;
