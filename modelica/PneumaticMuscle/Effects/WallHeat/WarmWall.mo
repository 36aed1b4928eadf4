within PneumaticMuscle.Effects.WallHeat;
model WarmWall "The wall warms up as a whole"
  extends Interfaces.Surroundings;
  extends FamilyMember(final absent="C=1e5");
  parameter Types.HeatCapacity C(min=1e-4, max=1e5, nominal=1) = 1 "Heat capacity of the wall"
    annotation (Dialog(group="Effect"));
  parameter Types.ThermalConductance G(min=0, max=50, nominal=0.02) = 0.02
    "Conductance from the wall to the surroundings"
    annotation (Dialog(group="Effect"));
  Types.Temperature T_w(start=ambient.T, fixed=dynamics == Types.Dynamics.FixedInitial) "Temperature of the wall";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(T_w) = 0;
  end if;
equation
  heatPort.T = T_w;
  C*der(T_w) = heatPort.Q_flow - G*(T_w - ambient.T);
  annotation (Documentation(info="<html>
<p>C T_w_dot = Q_flow - G (T_w - T_atm), behind the resistance of the base wall. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (44) takes the air outside for an infinite store of
heat; C is mass times specific heat capacity, typical 0.5 to 6 J/K for 0.254 mm of latex, of which the fibres leave a
part bare, and 5e3 J/K for a steel vessel of 16 L. G is area times an outer film of 5 to 20 W/(m2.K): 0.02 to 0.3 W/K
for a muscle. At C = 1e5 J/K the wall stays cold.</p>
<p>Fingerprint: pressure and temperature stay higher in a hold after filling than with a cold wall, the more so the
sooner fillings follow each other, and higher in and after the venting that follows, as long as the wall is warm and
gives its heat back; lower only once vented gas has cooled it. A vessel whose gas takes no heat from its wall does not
feel it.</p>
</html>"));
end WarmWall;
