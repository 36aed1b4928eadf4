within PneumaticMuscle.Muscles;
model DMSP20 "Festo DMSP-20, fluidic muscle with pressed fittings"
  extends Fluidic(redeclare replaceable record Sleeve = Data.DMSP20 constrainedby Data.SleeveData,
    membrane(p_0=0.3421e5, p_w=0.9607e5, eps_w=0.0308));
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>Geometry: <a href=\"modelica://PneumaticMuscle.Muscles.Data.DMSP20\">Data.DMSP20</a>. Wall: fitted to Table A1 of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, of which 13.4 N rms of 1654 N
are left. The length is <code>sleeve.L0</code>, that of the hose between the fittings, as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo 2005</a> counts it.</p>
</html>"));
end DMSP20;
