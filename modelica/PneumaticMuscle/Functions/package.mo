within PneumaticMuscle;
package Functions "Laws that several components use"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Formulas without state. All have finite derivatives for all arguments.</p>
</html>"));
end Functions;
