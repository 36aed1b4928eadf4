within PneumaticMuscle.Muscles;
model Fluidic "A fluidic muscle: fibres in a thick wall"
  extends FluidicSleeve;
  Laws.Elasticities.StiffWall membrane(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "What the wall takes of the pull"
    annotation (Placement(transformation(extent={{20,-60},{40,-40}})));
equation
  connect(port, membrane.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,-25}, {15,-25}, {15,-50}, {20,-50}}, color={0,90,160}));
  connect(flange_a, membrane.flange_a)
    annotation (Line(points={{0,-100}, {0,-65}, {30,-65}, {30,-60}}, color={0,110,60}));
  connect(flange_b, membrane.flange_b)
    annotation (Line(points={{0,100}, {0,15}, {15,15}, {15,-24}, {30,-24}, {30,-40}}, color={0,110,60}));
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Muscles.FluidicSleeve\">FluidicSleeve</a> with a wall that takes a part of its
pull, <a href=\"modelica://PneumaticMuscle.Laws.Elasticities.StiffWall\">Laws.Elasticities.StiffWall</a>, and of the
volume in it.</p>
</html>"));
end Fluidic;
