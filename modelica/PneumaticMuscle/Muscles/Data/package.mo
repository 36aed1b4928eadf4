within PneumaticMuscle.Muscles;
package Data "Parameter sets of the papers"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Records; a model takes its parameters from one of them, for example
<code>extends Isotonic(muscle(L0=data.L0, ...))</code> with <code>data = Muscles.Data.Butyl()</code>.</p>
</html>"));
end Data;
