within PneumaticMuscle.Muscles;
model FluidicSleeve "The sleeve of a fluidic muscle, fibres in rubber, without what its wall takes"
  extends AnyGeometry(redeclare replaceable record Sleeve = Data.DMSP20 constrainedby Data.SleeveData,
    fibres=1, mu_fb=0, mu_d=0, final V_solid=Constants.pi*t_wall*(D0 - t_wall)*L0);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>The cylinder of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1). The fibres lie in the rubber
and do not cross: no friction of fibre on fibre or on a bladder, DP (68)-(71), unless it is stated, and no share of the
outside that they cover. What hysteresis such a muscle has is left to effects; so is its wall here, for a measurement
that shall show what it does. <a href=\"modelica://PneumaticMuscle.Muscles.Fluidic\">Fluidic</a> has one.</p>
</html>"));
end FluidicSleeve;
