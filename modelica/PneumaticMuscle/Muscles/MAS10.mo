within PneumaticMuscle.Muscles;
model MAS10 "Festo MAS-10, fluidic muscle with screwed fittings"
  extends DMSP10;
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>The hose of the DMSP-10 with other fittings, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo
2005</a>; no measurement of its own was used.</p>
</html>"));
end MAS10;
