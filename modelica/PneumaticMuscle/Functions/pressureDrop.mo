within PneumaticMuscle.Functions;
function pressureDrop "Pressure drop divided by the upstream pressure, with the sign of the flow"
  extends Icons.Function;
  input Types.AbsolutePressure p_a "Pressure on side a";
  input Types.AbsolutePressure p_b "Pressure on side b";
  output Real z(unit="1") "1 - p_down/p_up, positive from a to b";
algorithm
  z := (p_a - p_b)/max(max(p_a, p_b), 1.0);
  annotation (Documentation(info="<html>
<p>z = (p_a - p_b)/max(p_a, p_b); the larger pressure is kept above 1 Pa.</p>
</html>"));
end pressureDrop;
