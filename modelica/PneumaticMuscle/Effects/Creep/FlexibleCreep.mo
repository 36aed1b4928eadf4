within PneumaticMuscle.Effects.Creep;
model FlexibleCreep "The bladder relaxes over two and a half decades of time"
  extends FamilyMember(final absent="k_1=0, k_2=0, k_3=0");
  parameter Types.TranslationalStiffness k_1(min=0, max=2e4, nominal=300) = 150 "Stiffness of the fastest element"
    annotation (Dialog(group="Effect"));
  parameter Types.TranslationalStiffness k_2(min=0, max=2e4, nominal=300) = 150
    "Stiffness of the element with seven times the time constant"
    annotation (Dialog(group="Effect"));
  parameter Types.TranslationalStiffness k_3(min=0, max=2e4, nominal=300) = 150
    "Stiffness of the element with 49 times the time constant"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=0.1, max=20, nominal=0.5) = 0.3 "Time constant of the fastest element"
    annotation (Dialog(group="Effect"));
  parameter Real thinning(unit="1", min=0, max=10, nominal=0.3) = 0.03
    "Relative increase of the rates with load, at the reference contraction"
    annotation (Dialog(group="Effect"));
  Types.Length q[3] "Parts of the contraction that have relaxed";
protected
  constant Types.Length x_reference = 0.01 "Contraction to which thinning refers";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    q = {x, x, x};
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(q) = zeros(3);
  end if;
equation
  for i in 1:3 loop
    7^(i - 1)*tau*der(q[i]) = (x - q[i])*(1 + thinning*((x - q[i])/x_reference)^2);
  end for;
  f = k_1*(x - q[1]) + k_2*(x - q[2]) + k_3*(x - q[3]);
  annotation (defaultComponentName="creep", Documentation(info="<html>
<p>Three Maxwell elements in parallel, a Prony series. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Ferry 1980</a>; a positive series of exponentials
dissipates and approaches any completely monotone relaxation. Over 0.02 to 10 s it is within 2.5 % of stretched
exponentials (Kohlrausch), of power laws that begin at a finite value and of the logarithm of time, where two elements
(<a href=\"modelica://PneumaticMuscle.Effects.Creep.PronyCreep\">PronyCreep</a>) leave up to 9 %. thinning multiplies
the rates by 1 + thinning (q_i's load by 10 mm)^2, two terms of the sinh of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Eyring 1936</a>, which still dissipates: a dashpot of his
is met within 1 % of what it changes in the readings. Typical 50 to 500 N/m, tau 0.1 to 1 s.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Creep.PronyCreep\">PronyCreep</a>; no time stands out
after which the creep is over.</p>
</html>"));
end FlexibleCreep;
