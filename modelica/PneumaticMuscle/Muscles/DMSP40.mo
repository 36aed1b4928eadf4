within PneumaticMuscle.Muscles;
model DMSP40 "Festo DMSP-40, fluidic muscle with pressed fittings"
  extends Fluidic(redeclare replaceable record Sleeve = Data.DMSP40 constrainedby Data.SleeveData,
    membrane(p_0=0.3421e5, p_w=0.9607e5, eps_w=0.0308));
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>Geometry: <a href=\"modelica://PneumaticMuscle.Muscles.Data.DMSP40\">Data.DMSP40</a>. Wall: taken from DMSP20, since
no measurement was found. The length is <code>sleeve.L0</code>, that of the hose between the fittings, as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo 2005</a> counts it.</p>
</html>"));
end DMSP40;
