within PneumaticMuscle.Laws;
package Gases "Pressure and temperature by flow, heat and work"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each extends <code>Interfaces.Gas</code> and is redeclared as the <code>Gas</code> of a muscle or a vessel.</p>
</html>"));
end Gases;
