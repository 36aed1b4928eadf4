within PneumaticMuscle.Functions;
function isentropicFlow "Mass flow rate through an orifice, either way, choked or not, DP (40)-(42)"
  extends Icons.Function;
  input Types.AbsolutePressure p_a "Pressure on side a";
  input Types.AbsolutePressure p_b "Pressure on side b";
  input Types.Temperature T_up "Temperature upstream";
  input Types.Area A "Effective area";
  output Types.MassFlowRate m_flow "Mass flow rate from a to b";
protected
  constant Real gamma = Constants.gamma "Ratio of specific heats";
  constant Real K = sqrt(gamma/Constants.R*(2/(gamma + 1))^((gamma + 1)/(gamma - 1))) "DP (42)";
  constant Real z_critical = 1 - (2/(gamma + 1))^(gamma/(gamma - 1)) "Relative pressure drop at which the flow chokes";
  constant Real N_scale = 2/(gamma - 1)*((gamma + 1)/2)^((gamma + 1)/(gamma - 1)) "Square of the factor in DP (40)";
  constant Real z_laminar = 3e-4 "Relative pressure drop below which the flow is laminar";
  Real z "Relative pressure drop, limited where the flow chokes";
  Real z_size "Its size, kept off zero";
  Real r "Pressure ratio";
algorithm
  z := max(-z_critical, min(z_critical, pressureDrop(p_a, p_b)));
  z_size := max(abs(z), 1e-6);
  r := 1 - z_size;
  m_flow := K*max(max(p_a, p_b), 1.0)*A/sqrt(T_up)
    *sqrt(N_scale*r^(2/gamma)*(1 - r^((gamma - 1)/gamma))/z_size)
    *z/(z^2 + z_laminar^2)^0.25;
  annotation (Documentation(info="<html>
<p>m_flow = K p_up A N(r)/sqrt(T_up), with r = p_down/p_up, N = 1 below the critical ratio 0.5283 and
N^2 = 2/(gamma - 1) ((gamma + 1)/2)^((gamma + 1)/(gamma - 1)) (r^(2/gamma) - r^((gamma + 1)/gamma)) above it,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42). Upstream is the side with the higher
pressure.</p>
<p>N has an infinite slope at r = 1. The factor z/(z^2 + z_laminar^2)^(1/4) takes the place of sqrt(z), z = 1 - r:
laminar where the pressure drop is below 3e-4 of the pressure, and lower by (1 + (z_laminar/z)^2)^(-1/4) beyond:
by 0.25 % at ten times that, by 0.1 % at sixteen times.
All derivatives are finite everywhere.</p>
</html>"));
end isentropicFlow;
