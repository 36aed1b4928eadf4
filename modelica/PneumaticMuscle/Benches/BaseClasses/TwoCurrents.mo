within PneumaticMuscle.Benches.BaseClasses;
partial model TwoCurrents "Currents of an inlet and of an exhaust valve"
  extends Icons.Named;
  Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-200,50},{-180,70}}),
      iconTransformation(extent={{-110,50},{-90,70}})));
  Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-200,-40},{-180,-20}}),
      iconTransformation(extent={{-110,-10},{-90,10}})));
  annotation (Diagram(coordinateSystem(preserveAspectRatio=true, extent={{-190,-180},{230,220}})),
    Documentation(info="<html>
<p>Inputs alone, so that they come first; <a
href=\"modelica://PneumaticMuscle.Benches.BaseClasses.CurrentSupply\">CurrentSupply</a> has the valves.</p>
</html>"));
end TwoCurrents;
