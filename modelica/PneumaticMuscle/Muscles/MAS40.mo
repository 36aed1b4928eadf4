within PneumaticMuscle.Muscles;
model MAS40 "Festo MAS-40, fluidic muscle with screwed fittings"
  extends DMSP40;
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>The hose of the DMSP-40 with other fittings, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo
2005</a>; no measurement of its own was used.</p>
</html>"));
end MAS40;
