within PneumaticMuscle.Effects.WallHeat;
model FlexibleWall "The wall warms up in two layers and gives its heat to the air by any power of the difference"
  extends Interfaces.Surroundings;
  extends FamilyMember(final absent="C=1e5");
  parameter Types.HeatCapacity C(min=1e-4, max=1e5, nominal=1) = 1 "Heat capacity of the inner layer"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance G(min=1e-5, max=50, nominal=0.02) = 0.02
    "Conductance to the surroundings at the reference difference"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=0, max=0.5, nominal=0.3) = 0.1 "Exponent of the temperature difference"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=0.01, max=100, nominal=1) = 0.3
    "Ratio of the heat capacities of outer and inner layer"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance K(min=1e-4, max=100, nominal=0.1) = 0.3 "Conductance between the layers"
    annotation (Dialog(group="Effect"));
  Types.Temperature T_w(start=ambient.T, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Temperature of the inner layer";
  Types.Temperature T_o(start=ambient.T, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Temperature of the outer layer";
protected
  constant Real T_reference_difference(unit="K") = 10 "Temperature difference at which G is meant";
  constant Real T_smooth(unit="K") = 0.05 "Temperature difference below which its size is rounded";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T_w) = 0;
    der(T_o) = 0;
  end if;
equation
  heatPort.T = T_w;
  C*der(T_w) = heatPort.Q_flow - K*(T_w - T_o);
  r*C*der(T_o) = K*(T_w - T_o)
    - G*(T_o - ambient.T)*exp(0.5*n*log(((T_o - ambient.T)^2 + T_smooth^2)/T_reference_difference^2));
  annotation (Documentation(info="<html>
<p>C T_w_dot = Q_flow - K (T_w - T_o), r C T_o_dot = K (T_w - T_o) - G (|T_o - T_atm|/10 K)^n (T_o - T_atm), behind
the resistance of the base wall. Source: two sections of the wall's heat equation; free convection has Nu ~ Gr^n, n =
1/4 laminar and 1/3 turbulent, 0 for wind and small differences
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">McAdams 1954</a>). Walls of two layers of any such loss
are met exactly. Typical C and G as for <a href=\"modelica://PneumaticMuscle.Effects.WallHeat.WarmWall\">WarmWall</a>, r
0.5 to 5, K 0.05 to 1 W/K for a muscle.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.WallHeat.WarmWall\">WarmWall</a>, with more than one
time after which the wall has cooled.</p>
</html>"));
end FlexibleWall;
