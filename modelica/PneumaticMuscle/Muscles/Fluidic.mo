within PneumaticMuscle.Muscles;
model Fluidic "A fluidic muscle: fibres in a thick wall"
  extends AnyGeometry(redeclare replaceable record Sleeve = Data.DMSP20 constrainedby Data.SleeveData,
    fibres=1, mu_fb=0, mu_d=0, final V_solid=Constants.pi*t_wall*(D0 - t_wall)*L0);
  Laws.Elasticities.StiffWall membrane(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "What the wall takes of the pull";
equation
  connect(port, membrane.port);
  connect(flange_a, membrane.flange_a);
  connect(flange_b, membrane.flange_b);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>The cylinder of DP (1) with a wall that takes a part of its pull, <code>Laws.Elasticities.StiffWall</code>, and of the
volume in it. The fibres lie in the rubber and do not cross: no friction of fibre on fibre or on a bladder, DP (68)-(71),
and no share of the outside that they cover. What hysteresis such a muscle has is left to effects.</p>
</html>"));
end Fluidic;
