within PneumaticMuscle.Functions;
function upstreamTemperature "Temperature on the side of the higher pressure, without a jump at equal pressures"
  extends Icons.Function;
  input Types.AbsolutePressure p_a "Pressure on side a";
  input Types.AbsolutePressure p_b "Pressure on side b";
  input Types.Temperature T_a "Temperature on side a";
  input Types.Temperature T_b "Temperature on side b";
  output Types.Temperature T_up "Temperature upstream";
protected
  constant Real z_blend = 3e-4 "Relative pressure drop over which the sides blend";
  Real z "Relative pressure drop";
algorithm
  z := pressureDrop(p_a, p_b);
  T_up := T_b + (T_a - T_b)*0.5*(1 + z/sqrt(z^2 + z_blend^2));
  annotation (Documentation(info="<html>
<p>T_up = T_b + (T_a - T_b) (1 + z/sqrt(z^2 + z_b^2))/2 with the relative pressure drop z: blended over 3e-4 of the
pressure.</p>
</html>"));
end upstreamTemperature;
