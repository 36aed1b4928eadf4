within PneumaticMuscle.Effects;
package WallHeat "A wall that becomes warm"
  extends Icons.WallHeat;
  annotation (Documentation(info="<html>
<p>The family <code>wall_heat</code>: heat that the wall stores, or gives to its surroundings late.</p>
<p>Fingerprint: pressure and temperature stay higher after filling and lower after venting than with a cold wall, the
more so the sooner fillings follow each other. A vessel whose gas takes no heat from its wall does not feel it.</p>
</html>"));
end WallHeat;
