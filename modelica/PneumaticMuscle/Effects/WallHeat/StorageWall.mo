within PneumaticMuscle.Effects.WallHeat;
model StorageWall "A wall that stores heat between a film inside and a film outside"
  extends Interfaces.Wall;
  extends FamilyMember(final absent="C=1e-4, r=1");
  parameter Types.HeatCapacity C(min=1e-4, max=1e5, nominal=1) = 1 "Heat capacity of the wall"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=0.01, max=50, nominal=1) = 1 "Ratio of the film coefficients outside and inside"
    annotation (Dialog(group="Effect"));
  Types.Temperature T_w(start=ambient.T) "Temperature of the wall";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    T_w = outside.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(T_w) = 0;
  end if;
equation
  heatPort.Q_flow*(1 + h_film*t/(2*k)) = h_film*A*(heatPort.T - T_w);
  outside.Q_flow*(1 + r*h_film*t/(2*k)) = r*h_film*A*(outside.T - T_w);
  C*der(T_w) = heatPort.Q_flow + outside.Q_flow;
  annotation (Documentation(info="<html>
<p>Film, half the wall, store of heat, half the wall, film. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (44)-(45) with the films of Laws.Heat.FilmWall;
typical C as for <a href=\"modelica://PneumaticMuscle.Effects.WallHeat.WarmWall\">WarmWall</a>, r 0.2 to 2. Without a
heat capacity and with r = 1 it is Laws.Heat.FilmWall; with a large one only the film inside and the inner half of the
wall resist.</p>
<p>It is absent where it stands for a wall between two films, as a muscle's. In place of a vessel's
<a href=\"modelica://PneumaticMuscle.Laws.Heat.MetalWall\">MetalWall</a>, which has no film outside, C = 1e-4 J/K and r
= 1 leave half of the conductance, and C = 1e5 J/K is the base.</p>
<p>Fingerprint: twice the heat flow at the beginning of a filling, so that pressure and temperature are at first lower
than with a wall that stores nothing; then, and in venting, as
<a href=\"modelica://PneumaticMuscle.Effects.WallHeat.WarmWall\">WarmWall</a>. A vessel whose gas takes no heat from its
wall does not feel it.</p>
</html>"));
end StorageWall;
