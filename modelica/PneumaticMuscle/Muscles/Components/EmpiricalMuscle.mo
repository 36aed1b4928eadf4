within PneumaticMuscle.Muscles.Components;
model EmpiricalMuscle "The empirical muscle of Dzahir and Yamamoto, DY (5)-(16)"
  extends Interfaces.MuscleTerminals(L0=0.3, D0=0.02, final turns=L0*tan(alpha_0)/(Constants.pi*D0), t_wall=1e-3);
  extends Icons.Muscle;
  parameter Real alpha_0(unit="rad", displayUnit="deg", min=0.1, max=0.9) = 23*Constants.pi/180 "Braid angle at rest"
    annotation (Dialog(group="Geometry"));
  replaceable model Braid = Laws.Forces.Empirical constrainedby Interfaces.Braid "Law of force"
    annotation (choicesAllMatching=true);
  replaceable model Friction = Laws.Frictions.LoadAndRate constrainedby Interfaces.ForceElement "Law of friction"
    annotation (choicesAllMatching=true);
  replaceable model Elasticity = Laws.Elasticities.StretchedSleeve constrainedby Interfaces.SleeveElasticity
    "Law of the stretched sleeve"
    annotation (choicesAllMatching=true);
  Braid braid(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Static force"
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  Friction friction(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Hysteresis"
    annotation (Placement(transformation(extent={{25,-10},{45,10}})));
  Elasticity elasticity(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Elasticity without pressure"
    annotation (Placement(transformation(extent={{60,-10},{80,10}})));
equation
  connect(port, braid.port)
    annotation (Line(points={{-100,0}, {-10,0}}, color={0,90,160}));
  connect(port, friction.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {20,15}, {20,0}, {25,0}}, color={0,90,160}));
  connect(port, elasticity.port)
    annotation (Line(points={{-100,0}, {-15,0}, {-15,15}, {55,15}, {55,0}, {60,0}}, color={0,90,160}));
  connect(flange_a, braid.flange_a)
    annotation (Line(points={{0,-100}, {0,-10}}, color={0,110,60}));
  connect(flange_a, friction.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {35,-15}, {35,-10}}, color={0,110,60}));
  connect(flange_a, elasticity.flange_a)
    annotation (Line(points={{0,-100}, {0,-15}, {70,-15}, {70,-10}}, color={0,110,60}));
  connect(flange_b, braid.flange_b)
    annotation (Line(points={{0,100}, {0,10}}, color={0,110,60}));
  connect(flange_b, friction.flange_b)
    annotation (Line(points={{0,100}, {0,19}, {35,19}, {35,10}}, color={0,110,60}));
  connect(flange_b, elasticity.flange_b)
    annotation (Line(points={{0,100}, {0,19}, {70,19}, {70,10}}, color={0,110,60}));
  annotation (Documentation(info="<html>
<p>F_dyn = F_s(P, eps) - F_elastic - F_hys, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (13),
(15), (16); eps = (L0 - length)/L0. Pressure is an input of the model: it stores no gas. DY identify the coefficients by
a swarm and tabulate none; the defaults are for illustration. Of a and b in the friction only the product can be found.
It needs a bench with an <a href=\"modelica://PneumaticMuscle.Excitation\">Excitation</a>, which says load
and frequency of the run.</p>
</html>"));
end EmpiricalMuscle;
