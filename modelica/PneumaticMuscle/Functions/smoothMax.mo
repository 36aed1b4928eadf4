within PneumaticMuscle.Functions;
function smoothMax "max(0, a) with a rounded corner"
  extends Icons.Function;
  input Real a "Argument";
  input Real width "Size of a over which the corner is rounded";
  output Real y "Rounded max(0, a)";
algorithm
  y := 0.5*(a + sqrt(a^2 + width^2));
  annotation (Documentation(info="<html>
<p>y = (a + sqrt(a^2 + width^2))/2: width/2 too large at a = 0, width^2/(4 a) beyond.</p>
</html>"));
end smoothMax;
