within PneumaticMuscle.Effects.Leak;
partial model ThresholdLeak "Gas escapes by a smooth law of what the gauge pressure has beyond a threshold"
  extends SmoothLeak;
  parameter Types.GaugePressure p_open(min=0, max=2e5, nominal=5e4) = 5e3 "Opening gauge pressure"
    annotation (Dialog(group="Effect"));
  parameter Real n_T(unit="1", min=-40, max=40, nominal=3) = 0 "Exponent of the temperature of the gas"
    annotation (Dialog(group="Effect"));
protected
  constant Real q_smooth(unit="1") = 0.03 "Pressure by the reference over which it opens";
  Real o(unit="1") = p_open/p_reference "Pressure at which it opens, by the reference";
  Real driving(unit="1") "Gauge pressure that drives the gas, by the reference";
  Real warm(unit="1") = log(max(port.T, 1.0)/ambient.T) "Logarithm of the temperature by the ambient one";
equation
  over = driving + 0.5*(sqrt((driving - o)^2 + q_smooth^2) - sqrt((driving + o)^2 + q_smooth^2));
  annotation (Documentation(info="<html>
<p>r = d - p_open/100 kPa beyond p_open and 0 below, rounded over 3 kPa. A relief valve or a lip opens at a
pressure; viscosity and density of the gas go with its temperature (n_T about -2), and a seal that shrinks ten times
as much as its groove opens in the cold, by the cube of the gap (n_T to -40). Left to the extending class:
<code>driving</code>, which is d, and <code>further</code>, with n_T <code>warm</code> among its terms.</p>
</html>"));
end ThresholdLeak;
