within PneumaticMuscle.Examples;
package Validation "Models that reproduce what the papers themselves found"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each puts the variants that a figure compares into one model. <code>scripts/pictures.py</code> draws them, the page
<code>docs/validation.md</code> shows them with figures measured. The papers' measurements are printed as pictures only,
so that what is compared are their statements.</p>
</html>"));
end Validation;
