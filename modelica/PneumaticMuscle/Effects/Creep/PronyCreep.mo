within PneumaticMuscle.Effects.Creep;
model PronyCreep "The bladder relaxes with two time constants, a decade apart"
  extends FamilyMember(final absent="k_1=0, k_2=0");
  parameter Types.TranslationalStiffness k_1(min=0, max=2e4, nominal=300) = 200 "Stiffness of the fastest element"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="MaxwellCreep"));
  parameter Types.TranslationalStiffness k_2(min=0, max=2e4, nominal=300) = 200
    "Stiffness of the element with ten times the time constant"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="MaxwellCreep"));
  parameter Types.Time tau(min=0.1, max=1e3, nominal=2) = 1 "Time constant of the fastest element"
    annotation (Dialog(group="Effect"), __PamCosim(at_max="LinearBladder"));
  Types.Length q[2] "Parts of the contraction that have relaxed";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    q = {x, x};
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(q) = zeros(2);
  end if;
equation
  tau*der(q[1]) = x - q[1];
  10*tau*der(q[2]) = x - q[2];
  f = k_1*(x - q[1]) + k_2*(x - q[2]);
  annotation (defaultComponentName="creep", Documentation(info="<html>
<p>Two Maxwell elements in parallel. Source: the generalised Maxwell model, a Prony series with one term a
decade as is usual for rubber (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Ferry 1980</a>). Typical as
for <a href=\"modelica://PneumaticMuscle.Effects.Creep.MaxwellCreep\">MaxwellCreep</a>.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Creep.MaxwellCreep\">MaxwellCreep</a>, fast at first and
slow later, like the logarithm of time.</p>
</html>"));
end PronyCreep;
