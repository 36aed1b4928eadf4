within PneumaticMuscle;
package Unknowns "Unknown inputs of the balances: terms without a law, to be estimated as signals from a measurement"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Each attaches as an effect does and adds one term, <code>missing</code>, to a balance. In a class named
<code>Missing...</code> it is a parameter that is zero in the model and is moved over time by who keeps the ledger: no
hypothesis, so that its family is <code>unknown</code> and a catalogue of effects leaves it out. A class that
extends the same partial class with a formula for <code>missing</code> is an effect like any other. The variables
that the partial classes declare are what a missing term is looked at against.</p>
</html>"));
end Unknowns;
