within PneumaticMuscle.Effects.ClockOffset;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.Effect(final family="clock_offset", final balance="sensor");
  extends Icons.ClockOffset;
  annotation (Documentation(info="<html>
<p>A member also extends <a href=\"modelica://PneumaticMuscle.Interfaces.Recorder\">Interfaces.Recorder</a>, whose place
it takes, and gives its equations.</p>
</html>"));
end FamilyMember;
