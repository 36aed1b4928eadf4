within PneumaticMuscle.Muscles;
model Physical "Muscle of Doumit and Pardoel with what carries it at full extension"
  extends Components.Muscle;
  extends Interfaces.RigMuscle(final x_start=-F_start/stop.k, usual=true);
  Mechanics.Components.Stop stop(L0=L0) "Full extension"
    annotation (Placement(transformation(extent={{75,-10},{95,10}})));
  Mechanics.Components.Fixed frame(s0=L0) "Where the muscle is fixed"
    annotation (Placement(transformation(extent={{30,65},{50,85}})));
equation
  connect(flange_b, frame.flange)
    annotation (Line(points={{0,100}, {0,60}, {40,60}, {40,65}}, color={0,110,60}));
  connect(flange_a, stop.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {85,-15}, {85,-10}}, color={0,110,60}));
  connect(flange_b, stop.flange_b)
    annotation (Line(points={{0,100}, {0,60}, {85,60}, {85,10}}, color={0,110,60}));
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Muscles.Components.Muscle\">Components.Muscle</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17), (59)-(60), (68)-(71). At zero gauge pressure
nothing in DP (17) carries a load: the braid does, as the stop of
<a href=\"modelica://PneumaticMuscle.Benches.Isotonic\">Benches.Isotonic</a>, on which the load rests at the start.</p>
</html>"));
end Physical;
