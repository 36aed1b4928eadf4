within PneumaticMuscle.Pneumatics.Components;
model ReviewedValves "Inlet and exhaust valve whose law of flow is one that the papers review"
  extends ValvePair;
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Pneumatics.Components.ValvePair\">ValvePair</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62); the laws of flow are in
<a href=\"modelica://PneumaticMuscle.Laws.Flows\">Laws.Flows</a>.</p>
</html>"));
end ReviewedValves;
