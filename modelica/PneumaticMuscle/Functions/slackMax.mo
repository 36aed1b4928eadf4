within PneumaticMuscle.Functions;
function slackMax "max(0, a) with a rounded corner, and nothing at all below it"
  extends Icons.Function;
  input Real a "Argument";
  input Real width "Size of a over which the corner is rounded";
  output Real y "Rounded max(0, a)";
protected
  Real c "Way through the corner, 0 to 1";
algorithm
  c := min(max(0.5*(a/width + 1), 0), 1);
  y := width*c^2 + max(a - width, 0);
  annotation (Documentation(info="<html>
<p>A parabola between a = -width and a = width, which meets 0 and a with their slopes. As <code>smoothMax</code>, of
which width^2/(4 |a|) is left far below the corner: a slack muscle under no load has nothing to hold it against such a
rest.</p>
</html>"));
end slackMax;
