model PulledMuscle "The isotonic bench with an unmeasured force on the load"
  extends PneumaticMuscle.Benches.Isotonic;
  import PneumaticMuscle.Types;
  input Types.Force F_ext(start=0) "Pull on the load, downwards";
  output Types.Force F = -muscle.flange_a.f "Pull of the muscle on the load";
  Pull pull(F=F_ext) "What pulls";
protected
  model Pull "A force on a flange"
    PneumaticMuscle.Interfaces.Flange flange "Where it pulls";
    input Types.Force F "Downwards";
  equation
    flange.f = F;
  end Pull;
equation
  connect(pull.flange, load.flange);
  annotation (Documentation(info="<html>
<p>m x_ddot = F - F_ext - m g, DP (18) with a further force.</p>
</html>"));
end PulledMuscle;
