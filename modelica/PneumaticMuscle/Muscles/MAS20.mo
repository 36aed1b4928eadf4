within PneumaticMuscle.Muscles;
model MAS20 "Festo MAS-20, fluidic muscle with screwed fittings"
  extends DMSP20;
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>The hose of the DMSP-20 with other fittings, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo
2005</a>; no measurement of its own was used.</p>
</html>"));
end MAS20;
