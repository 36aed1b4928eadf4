within PneumaticMuscle.Examples;
model ElasticButyl "The butyl muscle with the elasticity of its bladder"
  extends ButylIsotonic;
  extends Icons.Example;
  Effects.Elasticity.YoungBladder bladder(L0=muscle.L0, D0=muscle.D0, turns=muscle.turns, t_wall=muscle.t_wall, E=2e6)
    "Elasticity of the bladder";
equation
  connect(muscle.port, bladder.port);
  connect(muscle.flange_a, bladder.flange_a);
  connect(muscle.flange_b, bladder.flange_b);
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>How an effect is added: it has the terminals of the muscle, takes its geometry and is connected terminal by terminal.
A modulus of 2 MPa is usual for butyl rubber.</p>
</html>"));
end ElasticButyl;
