within PneumaticMuscle.Effects.Creep;
model MaxwellCreep "The bladder has a part whose stress relaxes"
  extends FamilyMember(final absent="k=0");
  parameter Types.TranslationalStiffness k(min=0, max=2e4, nominal=300) = 300 "Stiffness of the Maxwell element"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=0.1, max=1e4, nominal=2) = 2 "Time constant of relaxation"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="ViscousFriction", at_max="LinearBladder"));
  Types.Length q "Part of the contraction that has relaxed";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    q = x;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(q) = 0;
  end if;
equation
  tau*der(q) = x - q;
  f = k*(x - q);
  annotation (defaultComponentName="creep", Documentation(info="<html>
<p>A spring and a dashpot in series, f = k (x - q), tau q_dot = x - q. Source: Maxwell's element
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Ferry 1980</a>), the viscoelastic branch of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Reynolds and others 2003</a> and of later models of
muscles, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (6). Typical: a tenth to the whole of the
bladder's stiffness, 0.5 s to hours. Below 0.1 s it is a damper and not called creep.</p>
<p>Fingerprint: after a fast change the contraction goes on creeping in the hold while the pressure rests; at
the end of the hold nothing is left of the error. After venting it creeps back.</p>
</html>"));
end MaxwellCreep;
