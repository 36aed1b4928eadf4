within PneumaticMuscle.Interfaces;
partial model LoadedRig "What stands around a rig whose muscle must know the load and the frequency of the run"
  extends Rig;
  parameter Types.Force F_start "Static load" annotation (Dialog(group="Load"));
  parameter Real frequency(unit="Hz", min=0.01, max=100) = 0.5 "Frequency of the excitation"
    annotation (Dialog(group="Load"));
  inner Excitation excitation(F_load=F_start, frequency=frequency) "Load and frequency of the run"
    annotation (Placement(transformation(extent={{-50,70},{-10,110}})));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>F and f of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (10)-(11). The static load is what the
mechanics pull with at the start.</p>
</html>"));
end LoadedRig;
