within PneumaticMuscle.Mechanics.Components;
model Held "Ideal actuator: holds a flange at the position of the input"
  extends Icons.Motion;
  Interfaces.Flange flange "Held flange"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Signals.LengthInput s "Position"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
equation
  flange.s = s;
  annotation (Documentation(info="<html>
<p>For statics: whatever is attached must not depend on its speed.
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.ImposedPosition\">ImposedPosition</a> is for motion.</p>
</html>"));
end Held;
