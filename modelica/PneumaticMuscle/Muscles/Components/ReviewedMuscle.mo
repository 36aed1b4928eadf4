within PneumaticMuscle.Muscles.Components;
model ReviewedMuscle "A muscle with a place for each law that the papers review"
  extends Interfaces.MuscleTerminals(L0=0.24, D0=0.02, turns=2, t_wall=0.254e-3);
  extends Icons.Muscle;
  parameter Real n(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  replaceable model Force = Laws.Forces.NotChosen constrainedby Interfaces.Braid "Law of force; must be chosen"
    annotation (choicesAllMatching=true);
  replaceable model Friction = Laws.Frictions.NoFriction constrainedby Interfaces.ForceElement "Law of friction"
    annotation (choicesAllMatching=true);
  replaceable model Bladder = Laws.Frictions.NoFriction constrainedby Interfaces.ForceElement "Law of the bladder"
    annotation (choicesAllMatching=true);
  replaceable model Gas = Laws.Gases.Sorge constrainedby Interfaces.Gas "Law of the gas"
    annotation (choicesAllMatching=true);
  outer Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-90,70},{-70,90}})));
  Force force(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Sleeve"
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  Friction friction(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Friction"
    annotation (Placement(transformation(extent={{25,-10},{45,10}})));
  Bladder bladder(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Elasticity of the bladder"
    annotation (Placement(transformation(extent={{60,-10},{80,10}})));
  Gas gas(V=force.V, n=n, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p, T_reference=ambient.T, h_film=0,
    dynamics=ambient.dynamics)
    "Gas in the bladder"
    annotation (Placement(transformation(extent={{-60,30},{-40,50}})));
equation
  connect(port, gas.port)
    annotation (Line(points={{-100,0}, {-65,0}, {-65,40}, {-60,40}}, color={0,90,160}));
  connect(port, force.port)
    annotation (Line(points={{-100,0}, {-10,0}}, color={0,90,160}));
  connect(port, friction.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {20,15}, {20,0}, {25,0}}, color={0,90,160}));
  connect(port, bladder.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {55,15}, {55,0}, {60,0}}, color={0,90,160}));
  connect(flange_a, force.flange_a)
    annotation (Line(points={{0,-100}, {0,-10}}, color={0,110,60}));
  connect(flange_a, friction.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {35,-15}, {35,-10}}, color={0,110,60}));
  connect(flange_a, bladder.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {70,-15}, {70,-10}}, color={0,110,60}));
  connect(flange_b, force.flange_b)
    annotation (Line(points={{0,100}, {0,10}}, color={0,110,60}));
  connect(flange_b, friction.flange_b)
    annotation (Line(points={{0,100}, {0,19}, {35,19}, {35,10}}, color={0,110,60}));
  connect(flange_b, bladder.flange_b)
    annotation (Line(points={{0,100}, {0,19}, {70,19}, {70,10}}, color={0,110,60}));
  annotation (Documentation(info="<html>
<p>See <a href=\"modelica://PneumaticMuscle.Laws\">Laws</a> for what stands where. Volume and pressure are coupled as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (11) does; no heat is exchanged with a wall.</p>
</html>"));
end ReviewedMuscle;
