within PneumaticMuscle.Examples;
model ElasticButyl "The butyl muscle with the elasticity of its bladder"
  extends ButylIsotonic;
  extends Icons.Example;
  Effects.Elasticity.YoungBladder bladder(L0=muscle.L0, D0=muscle.D0, turns=muscle.turns, t_wall=muscle.t_wall, E=2e6)
    "Elasticity of the bladder"
    annotation (Placement(transformation(extent={{-20,-105},{20,-65}})));
equation
  connect(muscle.port, bladder.port)
    annotation (Line(points={{30,0}, {-5,0}, {-5,-60}, {-25,-60}, {-25,-85}, {-20,-85}}, color={0,90,160}));
  connect(muscle.flange_a, bladder.flange_a)
    annotation (Line(points={{50,-20}, {50,-60}, {25,-60}, {25,-110}, {0,-110}, {0,-105}}, color={0,110,60}));
  connect(muscle.flange_b, bladder.flange_b)
    annotation (Line(points={{50,20}, {50,25}, {0,25}, {0,-65}}, color={0,110,60}));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>How an effect is added: it has the terminals of the muscle, takes its geometry and is connected terminal by terminal.
A modulus of 2 MPa is usual for butyl rubber.</p>
</html>"));
end ElasticButyl;
