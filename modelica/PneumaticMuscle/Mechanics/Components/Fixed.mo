within PneumaticMuscle.Mechanics.Components;
model Fixed "A flange that does not move"
  extends Icons.Fixed;
  Interfaces.Flange flange "Held flange"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  parameter Types.Length s0 "Position" annotation (Dialog(group="Geometry"));
equation
  flange.s = s0;
  annotation (Documentation(info="<html>
<p>flange.s = s0.</p>
</html>"));
end Fixed;
