within PneumaticMuscle.Muscles.Data;
record AirMuscle "The air muscle of the slides"
  extends SleeveData(L0=0.3, D0=0.01, alpha_0=23*Constants.pi/180);
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a>, theoretical force equation 1: 30 cm, 1 cm, 23
deg.</p>
</html>"));
end AirMuscle;
