within PneumaticMuscle.Muscles;
model Fluidic "A fluidic muscle: fibres in a thick wall"
  extends FluidicSleeve;
  Laws.Elasticities.StiffWall membrane(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "What the wall takes of the pull";
equation
  connect(port, membrane.port);
  connect(flange_a, membrane.flange_a);
  connect(flange_b, membrane.flange_b);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><code>FluidicSleeve</code> with a wall that takes a part of its pull, <code>Laws.Elasticities.StiffWall</code>, and of the
volume in it.</p>
</html>"));
end Fluidic;
