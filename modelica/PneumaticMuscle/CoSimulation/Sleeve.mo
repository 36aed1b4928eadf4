within PneumaticMuscle.CoSimulation;
model Sleeve "A muscle without its gas: braid and friction; default parameters as Components.Muscle"
  extends Muscles.Components.FibreSleeve;
  Types.Area A = A_q "Area that exchanges heat with the gas";
  annotation (Documentation(info="<html>
<p>Force <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), friction DP (68)-(71), area of the
wall DP (48), as in <a href=\"modelica://PneumaticMuscle.Muscles.Components.Muscle\">Components.Muscle</a>. The port is
a pressure tap: the gas is in another model.</p>
</html>"));
end Sleeve;
