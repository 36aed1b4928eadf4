within PneumaticMuscle.Interfaces;
partial model PneumaticsWithLine "What feeds the gas port of a muscle through a line"
  extends Pneumatics;
  replaceable model Line = Laws.Lines.DirectLine constrainedby Interfaces.Line "Line to the muscle"
    annotation (choicesAllMatching=true);
  Line line "Line to the muscle"
    annotation (Placement(transformation(extent={{30,-20},{70,20}})));
equation
  connect(line.port_b, port)
    annotation (Line(points={{70,0}, {100,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>Left to the extending class: what stands at <code>line.port_a</code>. Where nothing is known of the line there is
none, <a href=\"modelica://PneumaticMuscle.Laws.Lines.DirectLine\">Laws.Lines.DirectLine</a>.</p>
</html>"));
end PneumaticsWithLine;
