within PneumaticMuscle.Laws.Gases;
model PolytropicVesselGas "Gas whose pressure and temperature follow a polytropic law, DP (60), (63)-(66)"
  extends Interfaces.Gas;
equation
  V*der(p) = n*(Constants.R*T*port.m_flow - p*der(V));
  T = T_reference*(p/p_reference)^((n - 1)/n);
  h_wall = h_film;
  annotation (Documentation(info="<html>
<p>p_dot = n R T/V m_flow, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (66), here with the work
of a moving wall. The exponent stands for whatever heat is exchanged, so the heat port has no part in it. That is not
consistent with an energy balance: a gas that rests at a pressure keeps its polytropic temperature for ever.</p>
</html>"));
end PolytropicVesselGas;
