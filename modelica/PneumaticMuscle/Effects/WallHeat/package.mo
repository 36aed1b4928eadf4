within PneumaticMuscle.Effects;
package WallHeat "A wall that becomes warm"
  extends Icons.WallHeat;
  annotation (Documentation(info="<html>
<p>The family <code>wall_heat</code>: heat that the wall stores, or gives to its surroundings late.</p>
<p>Fingerprint: pressure and temperature stay higher in a hold after filling than with a cold wall, the more so the
sooner fillings follow each other, and higher in and after the venting that follows, as long as the wall is warm and
gives its heat back; lower only once vented gas has cooled it. A vessel whose gas takes no heat from its wall does not
feel it.</p>
</html>"));
end WallHeat;
