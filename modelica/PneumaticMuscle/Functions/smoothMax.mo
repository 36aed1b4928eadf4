within PneumaticMuscle.Functions;
function smoothMax "max(0, a) with a rounded corner"
  input Real a "Argument";
  input Real width "Size of a over which the corner is rounded";
  output Real y "Rounded max(0, a)";
algorithm
  y := 0.5*(a + sqrt(a^2 + width^2));
end smoothMax;
