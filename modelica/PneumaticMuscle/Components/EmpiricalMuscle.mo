within PneumaticMuscle.Components;
model EmpiricalMuscle "The empirical muscle of Dzahir and Yamamoto, DY (5)-(16)"
  extends Interfaces.MuscleTerminals(L0=0.3, D0=0.02, final turns=L0*tan(alpha_0)/(Constants.pi*D0), t_wall=1e-3);
  extends Icons.Muscle;
  parameter Real alpha_0(unit="rad", displayUnit="deg", min=0.1, max=0.9) = 23*Constants.pi/180 "Braid angle at rest"
    annotation (Dialog(group="Geometry"));
  replaceable model Braid = Laws.Forces.Empirical constrainedby Interfaces.Braid "Law of force"
    annotation (choicesAllMatching=true);
  replaceable model Friction = Laws.Frictions.LoadAndRate constrainedby Interfaces.ForceElement "Law of friction"
    annotation (choicesAllMatching=true);
  replaceable model Elasticity = Laws.Elasticities.StretchedSleeve constrainedby Interfaces.SleeveElasticity "Law of the stretched sleeve"
    annotation (choicesAllMatching=true);
  Braid braid(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Static force";
  Friction friction(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Hysteresis";
  Elasticity elasticity(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Elasticity without pressure";
equation
  connect(port, braid.port);
  connect(port, friction.port);
  connect(port, elasticity.port);
  connect(flange_a, braid.flange_a);
  connect(flange_a, friction.flange_a);
  connect(flange_a, elasticity.flange_a);
  connect(flange_b, braid.flange_b);
  connect(flange_b, friction.flange_b);
  connect(flange_b, elasticity.flange_b);
  annotation (Documentation(info="<html>
<p>F_dyn = F_s(P, eps) - F_elastic - F_hys, DY (13), (15), (16); eps = (L0 - length)/L0. Pressure is an input of the
model: it stores no gas. DY identify the coefficients by a swarm and tabulate none; the defaults are for illustration.
Of a and b in the friction only the product can be found. It needs a bench with an <code>Excitation</code>, which says
load and frequency of the run.</p>
</html>"));
end EmpiricalMuscle;
