within PneumaticMuscle.Benches.BaseClasses;
partial model HungMuscle "A muscle that hangs from a ceiling"
  extends Icons.Named;
  replaceable Muscles.Components.Muscle muscle constrainedby Interfaces.MuscleTerminals "Muscle"
    annotation (choicesAllMatching=true, Placement(transformation(extent={{30,-20},{70,20}})));
  Mechanics.Components.Fixed ceiling(s0=muscle.L0) "Where the muscle hangs"
    annotation (Placement(transformation(extent={{30,60},{70,100}})));
equation
  connect(muscle.flange_b, ceiling.flange)
    annotation (Line(points={{50,20}, {50,60}}, color={0,110,60}));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p>The fixed end stands where the load end is at zero while the muscle has its length at rest. Left to the extending
class: what stands at the gas port and at the load end.</p>
</html>"));
end HungMuscle;
