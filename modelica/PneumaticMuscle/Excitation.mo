within PneumaticMuscle;
model Excitation
  "What is the same throughout a run: the load that hangs and the frequency at which the muscle is driven"
  extends Icons.Signal;
  parameter Types.Force F_load(min=0) "Static load" annotation (Dialog(group="Load"));
  parameter Real frequency(unit="Hz", min=0) "Frequency of the excitation" annotation (Dialog(group="Load"));
  annotation (defaultComponentName="excitation", defaultComponentPrefixes="inner",
    missingInnerMessage="Declare 'inner PneumaticMuscle.Excitation excitation(F_load=..., frequency=...)'.",
    Documentation(info="<html>
<p>F and f of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (10)-(11). Both are constants of a
run, neither is a variable of the muscle: the bench declares this <code>inner</code> with what it knows, and a law that
depends on them declares it <code>outer</code>. Such a law finds no place in a bench without it.</p>
</html>"));
end Excitation;
