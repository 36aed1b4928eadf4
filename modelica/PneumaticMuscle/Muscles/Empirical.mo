within PneumaticMuscle.Muscles;
model Empirical "Muscle of Dzahir and Yamamoto with the gas that it encloses"
  extends Components.EmpiricalMuscle;
  extends Interfaces.RigMuscle(final x_start=elasticity.x_rest);
  parameter Real n(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  replaceable model Gas = Laws.Gases.Sorge constrainedby Interfaces.Gas "Law of the gas"
    annotation (choicesAllMatching=true);
  outer Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-90,70},{-70,90}})));
  Gas gas(V=braid.V, n=n, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p, T_reference=ambient.T, h_film=0,
    dynamics=ambient.dynamics)
    "Gas in the bladder"
    annotation (Placement(transformation(extent={{-60,30},{-40,50}})));
  Mechanics.Components.Fixed frame(s0=L0) "Where the muscle is fixed"
    annotation (Placement(transformation(extent={{30,65},{50,85}})));
equation
  connect(port, gas.port)
    annotation (Line(points={{-100,0}, {-65,0}, {-65,40}, {-60,40}}, color={0,90,160}));
  connect(flange_b, frame.flange)
    annotation (Line(points={{0,100}, {0,60}, {40,60}, {40,65}}, color={0,110,60}));
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Muscles.Components.EmpiricalMuscle\">Components.EmpiricalMuscle</a>,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (5)-(16). DY impose the pressure; that a valve or a
regulator can feed the muscle, it encloses a gas, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(11), in the volume of its sleeve, without heat to a wall. The stretched sleeve carries the load at the start, DY (12).
Load and frequency of DY (10)-(11) are those of the rig; where the length is imposed the load is taken as zero, and the
friction that goes with it.</p>
</html>"));
end Empirical;
