within PneumaticMuscle.Effects.GasEnergy;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="gas_energy", final balance="energy");
  extends Icons.GasEnergy;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Gas\">Interfaces.Gas</a>, whose place it takes,
and gives its equations.</p>
</html>"));
end FamilyMember;
