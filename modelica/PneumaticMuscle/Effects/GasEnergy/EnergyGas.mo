within PneumaticMuscle.Effects.GasEnergy;
model EnergyGas "Pressure and temperature from mass and energy, with heat exchange to the wall"
  extends BalancedGas;
  extends FamilyMember;
  parameter Types.CoefficientOfHeatTransfer h(min=0.01, max=500, nominal=10) = 10 "Film coefficient at the wall"
    annotation (Dialog(group="Effect"));
equation
  h_wall = h;
  annotation (Documentation(info="<html>
<p>Ideal gas with mass and energy balance. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(43), (53), (54), (59); DP (60) falls away, so that no value of h gives the base law back. Typical 5 to 50 W/(m2.K). h
takes the place of the film coefficient that the owner assumes; a polytropic exponent of the owner has no effect any
more.</p>
<p>DP's own figures ask for it: with their wall as printed,
<a href=\"modelica://PneumaticMuscle.Laws.Heat.PrintedWall\">Laws.Heat.PrintedWall</a>, it gives the temperature of Fig.
12 in size and shape, where the power law stalls
(<a href=\"modelica://PneumaticMuscle.Examples.Validation.GasTemperature\">Validation.GasTemperature</a>). That wall has
no film, and h changes nothing there.</p>
<p>Fingerprint: the temperature returns to ambient in a hold and undershoots in venting; the pressure of a
vessel moves from the adiabatic to the isothermal curve as time goes on.</p>
</html>"));
end EnergyGas;
