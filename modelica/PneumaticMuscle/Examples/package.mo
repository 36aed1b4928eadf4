within PneumaticMuscle;
package Examples "Models that run as they are: a bench, its inputs, and what is worth a look"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each has its input signals built in and shows the bench's outputs. What reproduces a finding of a
paper is in <a href=\"modelica://PneumaticMuscle.Examples.Validation\">Validation</a>.</p>
</html>"));
end Examples;
