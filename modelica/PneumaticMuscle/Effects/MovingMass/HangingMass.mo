within PneumaticMuscle.Effects.MovingMass;
model HangingMass "Parts of the rig that hang on the muscle in addition to the load"
  extends FamilyMember(final absent="m=0");
  parameter Types.Mass m(min=0, max=50, nominal=0.5) = 0.5 "Mass" annotation (Dialog(group="Effect"));
equation
  f = m*(der(v) + Constants.g);
  annotation (defaultComponentName="movingMass", Documentation(info="<html>
<p>f = m (v_dot + g). Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (17) with the mass of
fittings, hook, sensor core and half of the muscle in the place of the load's. Typical 0.05 to 2 kg.
On a bench that starts at rest on its stop, the start is where the load alone rests: the weight of the effect settles
by m g/k of the stop in the first moments of each run, 0.05 mm for 1 kg.</p>
<p>Fingerprint: the contraction falls short by the same force at every load and pressure and in every hold, and
lift-off comes late; jumps are slower.</p>
</html>"));
end HangingMass;
