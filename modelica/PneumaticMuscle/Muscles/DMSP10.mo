within PneumaticMuscle.Muscles;
model DMSP10 "Festo DMSP-10, fluidic muscle with pressed fittings"
  extends Fluidic(redeclare replaceable record Sleeve = Data.DMSP10 constrainedby Data.SleeveData,
    membrane(p_0=0.2085e5, p_w=1.905e5, eps_w=0.0304));
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p>Geometry: <a href=\"modelica://PneumaticMuscle.Muscles.Data.DMSP10\">Data.DMSP10</a>. Wall: fitted to Table A2 of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, of which 6.1 N rms of 542 N
are left. The length is <code>sleeve.L0</code>, that of the hose between the fittings, as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo 2005</a> counts it.</p>
</html>"));
end DMSP10;
