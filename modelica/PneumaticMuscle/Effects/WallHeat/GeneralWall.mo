within PneumaticMuscle.Effects.WallHeat;
model GeneralWall
  "The wall stores heat in two layers behind any part of its resistance, "
  + "whose contact and loss follow any power of the difference"
  extends Interfaces.Wall;
  extends FamilyMember(final general=true, final absent="C=1e5, s=1");
  parameter Types.HeatCapacity C(min=1e-4, max=1e5, nominal=1) = 1 "Heat capacity of the inner layer"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance G(min=1e-5, max=50, nominal=0.02) = 0.02
    "Conductance to the outside at the reference difference"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=0, max=1, nominal=0.3) = 0.1 "Exponent of the temperature difference"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=0.01, max=100, nominal=1) = 0.3
    "Ratio of the heat capacities of outer and inner layer"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance K(min=1e-4, max=100, nominal=0.1) = 0.3
    "Conductance between the layers at the reference area"
    annotation (Dialog(group="Effect"));
  parameter Real grip(unit="1", min=-10, max=10, nominal=2) = 0 "Exponent of the area"
    annotation (Dialog(group="Effect"));
  parameter Real s(unit="1", min=0, max=1, nominal=0.3) = 0.5
    "Fraction of the resistance of wall and outer film before the inner layer"
    annotation (Dialog(group="Effect"));
  Types.Temperature T_w(start=ambient.T) "Temperature of the inner layer";
  Types.Temperature T_o(start=ambient.T) "Temperature of the outer layer";
protected
  constant Real T_reference_difference(unit="K") = 10 "Temperature difference at which G is meant";
  constant Real T_smooth(unit="K") = 0.05 "Temperature difference below which its size is rounded";
  constant Types.Area A_reference = 0.015 "Area at which K is meant";
  constant Types.Area A_least = 1e-6 "Area below which the contact of the layers stays as it is";
  Types.ThermalConductance K_A = K*exp(grip*log(max(A, A_least)/A_reference)) "Conductance between the layers";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    T_w = outside.T;
    T_o = outside.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(T_w) = 0;
    der(T_o) = 0;
  end if;
equation
  heatPort.Q_flow*(1 + s*(1 + h_film*t/k)) = h_film*A*(heatPort.T - T_w);
  C*der(T_w) = heatPort.Q_flow - K_A*(T_w - T_o);
  r*C*der(T_o) = K_A*(T_w - T_o) + outside.Q_flow;
  outside.Q_flow = G*(outside.T - T_o)*exp(0.5*n*log(((T_o - outside.T)^2 + T_smooth^2)/T_reference_difference^2));
  annotation (Documentation(info="<html>
<p>Q_flow (1/h_film + s (1/h_film + t/k)) = A (T_gas - T_w), C T_w_dot = Q_flow - K (A/150 cm2)^grip (T_w - T_o), r C
T_o_dot = K (A/150 cm2)^grip (T_w - T_o) - G (|T_o - T_out|/10 K)^n (T_o - T_out). Source:
<a href=\"modelica://PneumaticMuscle.Effects.WallHeat.FlexibleWall\">FlexibleWall</a> (s = 1) and
<a href=\"modelica://PneumaticMuscle.Effects.WallHeat.StorageWall\">StorageWall</a>, see there, in one; layers that
touch where they are pressed conduct the better, the more the bladder is stretched. Typical as there. Areas below 1
mm2, where fibres cover the bladder, count as 1 mm2 in the contact.</p>
<p>It is absent where it stands for a wall between two films, as a muscle's. In place of a vessel's
<a href=\"modelica://PneumaticMuscle.Laws.Heat.MetalWall\">MetalWall</a>, which has no film outside, C = 1e5 J/K and s =
1 leave half of the conductance, and s = 0 is the base.</p>
<p>Fingerprint: as those.</p>
</html>"));
end GeneralWall;
