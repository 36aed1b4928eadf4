within PneumaticMuscle.Functions;
function curvedPower "A power of u whose exponent itself changes with the size of u"
  extends Icons.Function;
  input Real u "Argument, by its reference size";
  input Real a "Exponent at the reference size, less one";
  input Real b "Half of what the exponent gains where u grows by the factor e";
  input Real width "Size of u below which the law is linear";
  output Real y "u at the reference size, with the sign of u everywhere";
protected
  Real l "Logarithm of the size of u, kept off zero";
algorithm
  l := 0.5*log(u^2 + width^2);
  y := u*exp(l*(a + b*l));
  annotation (Documentation(info="<html>
<p>y = u |u|^(a + b ln|u|): ln|y| is a parabola in ln|u|, a power law where b = 0. Source: the log-normal
(log-parabolic) law, the next term after the power law in the expansion of ln y by ln u. Never changes its sign, however
a and b are chosen; all derivatives are finite.</p>
</html>"));
end curvedPower;
