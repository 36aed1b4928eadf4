within PneumaticMuscle.Interfaces;
partial model Mechanics "What holds the load ends of one or several muscles"
  extends RigPart;
  parameter Types.Force F_start "Force with which it pulls at each muscle at the start"
    annotation (Dialog(group="Start"));
  parameter Types.Length x_start "Contraction at which the muscle carries that force without pressure"
    annotation (Dialog(group="Start"));
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Each <a href=\"modelica://PneumaticMuscle.Interfaces.Flange\">Interfaces.Flange</a> of an extending class is the load
end of one muscle. Left to the extending class: the flanges, the equations of motion, and the value of F_start; x_start
is the muscle's.</p>
</html>"));
end Mechanics;
