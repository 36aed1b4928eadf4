within PneumaticMuscle.Mechanics;
model HangingLoad "A mass that hangs on the muscle"
  extends Interfaces.Mechanics(shows="x", final F_start=m*Constants.g);
  extends Components.Load(final s_start=x_start);
  annotation (defaultComponentName="load", Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Mechanics.Components.Load\">Components.Load</a>, m x_ddot = F - m g,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (16)-(18). It begins where the muscle carries it
without pressure.</p>
</html>"));
end HangingLoad;
