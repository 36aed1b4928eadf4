within PneumaticMuscle.Examples;
package Sources "Input signals over time for examples"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Functions of time alone. Corners are rounded, because the models have no events.</p>
</html>"));
end Sources;
