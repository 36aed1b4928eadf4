within PneumaticMuscle.Muscles;
model Physical "Muscle of Doumit and Pardoel with what carries it at full extension"
  extends Components.Muscle;
  extends Interfaces.RigMuscle(final x_start=-F_start/stop.k, usual=true);
  Components.Stop stop(L0=L0) "Full extension";
  Components.Fixed frame(s0=L0) "Where the muscle is fixed";
equation
  connect(flange_b, frame.flange);
  connect(flange_a, stop.flange_a);
  connect(flange_b, stop.flange_b);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><code>Components.Muscle</code>, DP (17), (59)-(60), (68)-(71). At zero gauge pressure nothing in DP (17) carries a load: the braid
does, as the stop of <code>Benches.Isotonic</code>, on which the load rests at the start.</p>
</html>"));
end Physical;
