within PneumaticMuscle.Benches.BaseClasses;
partial model LiftedMass "A muscle that lifts a hanging mass from the stop of its full length"
  extends HungMuscle;
  Mechanics.Components.Load load(s_start=-load.m*Constants.g/stop.k) "Hanging mass, at rest on the stop"
    annotation (Placement(transformation(extent={{30,-105},{70,-65}})));
  Mechanics.Components.Stop stop(L0=muscle.L0) "Full extension"
    annotation (Placement(transformation(extent={{95,-20},{135,20}})));
equation
  connect(muscle.flange_a, load.flange)
    annotation (Line(points={{50,-20}, {50,-65}}, color={0,110,60}));
  connect(muscle.flange_a, stop.flange_a)
    annotation (Line(points={{50,-20}, {50,-40}, {115,-40}, {115,-20}}, color={0,110,60}));
  connect(muscle.flange_b, stop.flange_b)
    annotation (Line(points={{50,20}, {50,40}, {115,40}, {115,20}}, color={0,110,60}));
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (16)-(18) and Fig. 2. Without pressure the stop
carries the mass, k x = -m g. Left to the extending class: what stands at the gas port.</p>
</html>"));
end LiftedMass;
