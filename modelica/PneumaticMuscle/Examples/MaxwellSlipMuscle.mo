within PneumaticMuscle.Examples;
model MaxwellSlipMuscle "Hysteresis by Maxwell-slip elements, DP (12)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord,
    redeclare model Friction = Effects.DryFriction.MaxwellSlipFriction));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>Friction without memory of rate: the same loop at every speed.</p>
</html>"));
end MaxwellSlipMuscle;
