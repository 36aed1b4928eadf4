within PneumaticMuscle.Effects.GasEnergy;
model FreeConvectionGas "Mass and energy balance, with heat exchange by free convection"
  extends BalancedGas;
  extends FamilyMember;
  parameter Real c(unit="1", min=1e-3, max=10, nominal=0.1) = 0.13
    "Nusselt number by the third root of the Rayleigh number"
    annotation (Dialog(group="Effect"));
  outer Ambient ambient "Surroundings";
protected
  constant Types.ThermalConductivity k = 0.026 "Thermal conductivity of air";
  constant Real mu(unit="Pa.s") = 1.85e-5 "Viscosity of air";
  constant Real Pr(unit="1") = 0.71 "Prandtl number of air";
  constant Types.Temperature dT_smooth = 0.1 "Difference of temperature below which its size is rounded";
equation
  h_wall = c*k*(Constants.g*Pr/(mu^2*ambient.T)*(p/(Constants.R*T))^2)^(1/3)*((T - ambient.T)^2 + dT_smooth^2)^(1/6);
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">EnergyGas</a> with Nu = c Ra^(1/3), so that h =
c k (g Pr rho^2 |T - T_w|/(mu^2 T_w))^(1/3) whatever the size of the vessel. The wall has the temperature of the
surroundings. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">McAdams 1954</a>, turbulent free
convection, c = 0.13; <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43), (53), (54), (59). DP
(60) falls away, so that no value of c gives the base law back. Typical 0.1 to 0.2 in vessels of litres; h = 8.2 to 10.4
W/(m2.K) for air at 100 kPa gauge and 5.2 to 6.5 at 100 kPa absolute, if it is 50 K warmer or colder than a wall at 20
degC.</p>
<p>Open: a muscle's wall takes the same film, with the pressure of the inside, for its outer side too, see
<a href=\"modelica://PneumaticMuscle.Laws.Heat.FilmWall\">Laws.Heat.FilmWall</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">EnergyGas</a>, with more heat
exchange while the gas is dense and its temperature far from the wall's, and less and less in the end.</p>
</html>"));
end FreeConvectionGas;
