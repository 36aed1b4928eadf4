within PneumaticMuscle.Examples.Validation;
model TankCurves "The sixteen curves of tank filling and emptying, DP section 4.4, Figs. 4 and 5"
  extends Icons.Validation;
  constant Types.Volume V[8] = {2.1e-3, 1.85e-3, 1.6e-3, 1.35e-3, 1.1e-3, 0.85e-3, 0.6e-3, 0.35e-3} "Volumes";
  parameter Real n(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent" annotation (Dialog(group="Gas"));
  output Types.GaugePressure p_207[8] = high.p "Gauge pressures, supply 207 kPa";
  output Types.GaugePressure p_138[8] = low.p "Gauge pressures, supply 138 kPa";
  Sources.Pulse inlet(start=-1, stop=40) "Current of the inlet valve"
    annotation (Placement(transformation(extent={{-70,20},{-30,60}})));
  Sources.Pulse outlet(start=40, stop=1000) "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{-70,-60},{-30,-20}})));
  Benches.TankFilling high[8](each u_in=inlet.y, each u_out=outlet.y, each p_supply=207e3, tank(V=V, each n=n))
    "Supply of 207 kPa"
    annotation (Placement(transformation(extent={{30,20},{70,60}})));
  Benches.TankFilling low[8](each u_in=inlet.y, each u_out=outlet.y, each p_supply=138e3, tank(V=V, each n=n))
    "Supply of 138 kPa"
    annotation (Placement(transformation(extent={{30,-60},{70,-20}})));
  annotation (experiment(StopTime=100, Interval=0.1, Tolerance=1e-6), Documentation(info="<html>
<p>Inflation for 40 s, then deflation, both at 0.35 A. The test of the library checks the times against quadrature.</p>
</html>"));
end TankCurves;
