within PneumaticMuscle.Interfaces;
partial model RigMuscle "A muscle that a rig can be put together with"
  extends RigPart;
  constant Boolean usual = false "It is meant where no muscle is named";
  parameter Types.Force F_start "Force that pulls at it at the start" annotation (Dialog(group="Start"));
  parameter Types.Length x_start "Contraction at which it carries that force without pressure"
    annotation (Dialog(group="Start"));
  annotation (Documentation(info="<html>
<p>An extending class is also one of
<a href=\"modelica://PneumaticMuscle.Interfaces.MuscleTerminals\">MuscleTerminals</a>; it holds its fixed end itself,
and says in x_start where it hangs under the load F_start while it has no pressure.</p>
</html>"));
end RigMuscle;
