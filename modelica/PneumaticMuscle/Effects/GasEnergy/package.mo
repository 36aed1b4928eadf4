within PneumaticMuscle.Effects;
package GasEnergy "Gas that keeps a balance of energy"
  extends Icons.GasEnergy;
  annotation (Documentation(info="<html>
<p>The family <code>gas_energy</code>: mass and energy balances of the gas in place of a polytropic law.</p>
<p>Fingerprint: the temperature returns to that of the surroundings in a hold and undershoots in venting; the pressure
of a vessel moves from the adiabatic to the isothermal curve as time goes on. Members differ in the film between gas and
wall.</p>
</html>"));
end GasEnergy;
