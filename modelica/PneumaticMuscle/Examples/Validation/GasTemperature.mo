within PneumaticMuscle.Examples.Validation;
model GasTemperature
  "Temperature of the latex muscle with DP (45) as printed: "
  + "by the power law (60) and by the balance of energy, DP Fig. 12"
  extends Icons.Validation;
  constant Real n_g[2](each unit="1") = {1.2, 1.4} "Polytropic exponents";
  constant Real mu_fb[2](each unit="1") = {0.015, 0.04}
    "Coefficients of friction between fibres and bladder: DP Table 1, DP Fig. 12";
  output Types.GaugePressure p_power[2] = power.p "Gauge pressures, power law";
  output Types.Length x_power[2] = power.x "Contractions, power law";
  output Types.Temperature T_power[2] = power.T "Gas temperatures, power law";
  output Types.GaugePressure p_energy[2] = energy.p "Gauge pressures, balance of energy";
  output Types.Length x_energy[2] = energy.x "Contractions, balance of energy";
  output Types.Temperature T_energy[2] = energy.T "Gas temperatures, balance of energy";
  output Types.Temperature T_slow "What the balance of energy comes to where the pressure varies slowly";
  Sources.Pulse inlet(start=-1, stop=5) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=5, stop=100) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Examples.PrintedWallIsotonic power[2](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3, muscle(n_g=n_g))
    "Temperature by the power law"
    annotation (Placement(transformation(extent={{30,20},{70,60}})));
  Examples.PrintedWallEnergyGas energy[2](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3,
    muscle(mu_fb=mu_fb))
    "Temperature by the balance of energy"
    annotation (Placement(transformation(extent={{30,-60},{70,-20}})));
equation
  T_slow = energy[1].ambient.T + energy[1].muscle.gas.V*der(energy[1].muscle.gas.p)
    *energy[1].muscle.wall.t/(energy[1].muscle.wall.k*energy[1].muscle.wall.A);
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>All with h_c = k/t_b, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (45) as printed. With the
power law reading of DP (60) the pressure stalls. With
<a href=\"modelica://PneumaticMuscle.Effects.GasEnergy.EnergyGas\">Effects.GasEnergy.EnergyGas</a> the muscle fills, the
gas warms by 4.5 K while it fills (8.6 K for a moment), returns to ambient and cools by 5 K while it is vented: of the
size that DP's model has in Fig. 12 (about 4 K for n_g = 1.4), with the shape that DP measured (a rise, then a fall
below the initial value).</p>
<p>DP print (60) as t/T = (n_g - 1)/n_g p/P, in one line, and say that it \"relies on pressure variation\". Where the
wall conducts well the balance of energy says just that: with T near ambient, DP (43) and (54) give
T - T_atm = V p_dot/(h_c A_q), filling and venting, whatever the contraction does. <code>T_slow</code> is this limit. It
has no exponent in it, so that it does not settle what DP plotted for three.</p>
</html>"));
end GasTemperature;
