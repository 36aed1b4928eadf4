within PneumaticMuscle.Components;
model Held "Holds a flange where the input says, at once"
  Interfaces.Flange flange "Held flange";
  input Types.Length s "Position";
equation
  flange.s = s;
  annotation (Documentation(info="<html>
<p>For statics: whatever is attached must not depend on its speed. <code>ImposedPosition</code> is for motion.</p>
</html>"));
end Held;
