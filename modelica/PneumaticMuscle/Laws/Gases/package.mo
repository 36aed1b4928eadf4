within PneumaticMuscle.Laws;
package Gases "Pressure and temperature by flow, heat and work"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <a href=\"modelica://PneumaticMuscle.Interfaces.Gas\">Interfaces.Gas</a> and is redeclared as the
<code>Gas</code> of a muscle or a vessel.</p>
</html>"));
end Gases;
