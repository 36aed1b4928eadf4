within PneumaticMuscle.Components;
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
  outer Ambient ambient "Surroundings";
  Force force(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Sleeve";
  Friction friction(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Friction";
  Bladder bladder(L0=L0, D0=D0, turns=turns, t_wall=t_wall) "Elasticity of the bladder";
  Gas gas(V=force.V, n=n, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p, T_reference=ambient.T, h_film=0)
    "Gas in the bladder";
equation
  connect(port, gas.port);
  connect(port, force.port);
  connect(port, friction.port);
  connect(port, bladder.port);
  connect(flange_a, force.flange_a);
  connect(flange_a, friction.flange_a);
  connect(flange_a, bladder.flange_a);
  connect(flange_b, force.flange_b);
  connect(flange_b, friction.flange_b);
  connect(flange_b, bladder.flange_b);
  annotation (Documentation(info="<html>
<p>See <code>Laws</code> for what stands where. Volume and pressure are coupled as DP (11) does; no heat is
exchanged with a wall.</p>
</html>"));
end ReviewedMuscle;
