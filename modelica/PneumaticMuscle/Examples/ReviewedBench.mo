within PneumaticMuscle.Examples;
partial model ReviewedBench "A bench for the laws that the papers review"
  extends Interfaces.Rig;
  extends Benches.BaseClasses.CurrentSupply;
  extends Benches.BaseClasses.LiftedMass(redeclare Muscles.Components.ReviewedMuscle muscle);
  extends Benches.BaseClasses.PressureReading(channel_p(dynamics=ambient.dynamics));
  extends Benches.BaseClasses.PositionReading(channel_x(dynamics=ambient.dynamics));
  extends Icons.Example;
equation
  connect(line.port_b, muscle.port)
    annotation (Line(points={{-10,0}, {30,0}}, color={0,90,160}));
  connect(muscle.port, manometer.port)
    annotation (Line(points={{30,0}, {10,0}, {10,110}}, color={0,90,160}));
  connect(muscle.flange_a, ruler.flange)
    annotation (Line(points={{50,-20}, {50,-40}, {80,-40}, {80,-85}, {95,-85}}, color={0,110,60}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Benches.Isotonic</a> with a
<a href=\"modelica://PneumaticMuscle.Muscles.Components.ReviewedMuscle\">Components.ReviewedMuscle</a>. The law of force
must be chosen: <code>extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord))</code>.</p>
</html>"));
end ReviewedBench;
