within PneumaticMuscle.Effects;
model FlexibleMass "Moving parts whose inertia and weight count differently"
  extends Interfaces.ForceEffect(final family="moving_mass", final absent="m=0");
  parameter Types.Mass m(min=0, max=100, nominal=1) = 1 "Inertia, referred to the load end";
  parameter Real share(unit="1", min=0, max=3, nominal=0.5) = 0.5 "Share of it that hangs on the muscle";
equation
  f = m*(der(v) + share*Constants.g);
  annotation (defaultComponentName="movingMass", Documentation(info="<html>
<p>f = m (v_dot + share g). Source: DP (17) for parts on a lever of the ratio i, with inertia i^2 and weight i of
their mass, or partly balanced; share = 1 is HangingMass, 0 is BalancedMass. Typical 0.1 to 20 kg.</p>
<p>Fingerprint: as HangingMass, with jumps that are slower or faster than its weight lets expect.</p>
</html>"));
end FlexibleMass;
