within PneumaticMuscle.Effects.DeadVolume;
model DeadVolume "Gas in fittings that takes no part in contraction"
  extends FamilyMember(final absent="V_d=0");
  parameter Types.Volume V_d(min=0, max=1e-3, nominal=1e-5) = 1e-5 "Volume" annotation (Dialog(group="Effect"));
protected
  Types.Mass m(nominal=1e-5) = port.p*V_d/(Constants.R*port.T) "Mass of the gas in it";
equation
  port.m_flow = der(m);
  port.H_flow = V_d/(Constants.gamma - 1)*der(port.p);
  annotation (defaultComponentName="deadVolume", Documentation(info="<html>
<p>Ideal gas of the pressure and temperature of the host's: mass m = p V_d/(R T), internal energy p V_d/(gamma -
1). Source: the balances <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43) and (59) for a volume
that does not change. Typical 1 to 30 mL for a muscle, as much as some percent of a vessel.</p>
<p>Fingerprint: filling and venting are slower by a factor that is largest while the muscle is long and its own
volume small; against a smaller C_A the beginning is slower than the end. The holds are right.</p>
</html>"));
end DeadVolume;
