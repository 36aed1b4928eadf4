within PneumaticMuscle.Effects.SupplyLine;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="supply_line", final balance="mass");
  extends Icons.SupplyLine;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Line\">Interfaces.Line</a>, behind the valves,
or <a href=\"modelica://PneumaticMuscle.Interfaces.Feed\">Interfaces.Feed</a>, before the inlet valve, whose place it
takes, and gives its equations.</p>
</html>"));
end FamilyMember;
