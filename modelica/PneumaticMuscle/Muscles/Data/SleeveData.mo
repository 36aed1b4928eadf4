within PneumaticMuscle.Muscles.Data;
record SleeveData "Measures of a sleeve at rest; zero is not stated"
  extends Icons.Record;
  parameter Types.Length L0(min=0, max=10) = 0 "Length at rest, fittings included"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length fittings(min=0, max=1) = 0 "What of that length does not contract"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length D0(min=0, max=0.2) = 0 "Diameter on which the fibres lie"
    annotation (Dialog(group="Geometry"));
  parameter Real turns(unit="1", min=0, max=200) = 0 "Turns of a fibre about the muscle (n)"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length b(min=0, max=20) = 0 "Length of a fibre" annotation (Dialog(group="Geometry"));
  parameter Real alpha_0(unit="rad", displayUnit="deg", min=0, max=1.5) = 0 "Angle between fibres and axis"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length t_wall(min=1e-5, max=0.02) = 0.254e-3 "Thickness of the wall"
    annotation (Dialog(group="Geometry"));
  annotation (Documentation(info="<html>
<p>L0 - fittings = b cos(alpha_0) and n pi D0 = b sin(alpha_0),
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1): three of L0, D0, n, b and alpha_0 determine the
sleeve if D0 or n is among them. <a href=\"modelica://PneumaticMuscle.Muscles.AnyGeometry\">Muscles.AnyGeometry</a>
calculates the others.</p>
</html>"));
end SleeveData;
