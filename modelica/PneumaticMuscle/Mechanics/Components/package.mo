within PneumaticMuscle.Mechanics;
package Components "Loads, stops, drives and what holds a flange"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Of these the parts in <a href=\"modelica://PneumaticMuscle.Mechanics\">Mechanics</a> and the benches are made.</p>
</html>"));
end Components;
