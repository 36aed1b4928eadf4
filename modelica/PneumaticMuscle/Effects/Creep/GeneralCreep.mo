within PneumaticMuscle.Effects.Creep;
model GeneralCreep
  "The bladder's spring, of any law, relaxes over decades of time, recovers in another, and faster when warm"
  extends FamilyMember(final general=true, final absent="k_1=0, k_2=0, k_3=0");
  parameter Types.TranslationalStiffness k_1(min=0, max=2e4, nominal=300) = 150 "Stiffness of the fastest element"
    annotation (Dialog(group="Effect"));
  parameter Types.TranslationalStiffness k_2(min=0, max=2e4, nominal=300) = 150 "Stiffness of the middle element"
    annotation (Dialog(group="Effect"));
  parameter Types.TranslationalStiffness k_3(min=0, max=2e4, nominal=300) = 150 "Stiffness of the slowest element"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=0.02, max=20, nominal=0.5) = 0.3 "Time constant of the fastest element"
    annotation (Dialog(group="Effect"));
  parameter Real spread(unit="1", min=2, max=12, nominal=5) = 7 "Ratio of successive time constants"
    annotation (Dialog(group="Effect"));
  parameter Real thinning(unit="1", min=0, max=10, nominal=0.3) = 0.03
    "Relative increase of the rates with load, at the reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real stiffening(unit="1", min=0, max=10, nominal=0.3) = 0
    "Relative increase of the stiffnesses with load, at the reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real hardening(unit="1", min=-4, max=8, nominal=1) = 0
    "Exponent of the decrease of the rates with relaxation"
    annotation (Dialog(group="Effect"));
  parameter Real recovery(unit="1", min=0.1, max=10, nominal=1) = 1 "Times of recovery by those of relaxation"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-1, max=2.5, nominal=0.3) = 0
    "Relative growth of all stiffnesses per eighth of the length"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.3, max=0.5, nominal=0.1) = 0 "Quadratic coefficient of the growth"
    annotation (Dialog(group="Effect"));
  parameter Real h(unit="1", min=-1, max=2, nominal=0.3) = 0 "Exponent of the pressure in all stiffnesses"
    annotation (Dialog(group="Effect"));
  parameter Real warm(unit="1", min=-1, max=1, nominal=0.2) = 0
    "Increase of the logarithm of the rates per 10 K above ambient temperature"
    annotation (Dialog(group="Effect"));
  Types.Length q[3] "Parts of the spring's load that have relaxed, as contractions";
protected
  constant Types.Pressure p_reference = 1e5 "Gauge pressure at which what it adds doubles its base";
  constant Real q_least(unit="1") = 0.02 "Least value of that";
  constant Real T_step(unit="K") = 10 "Temperature to which warm refers";
  constant Types.Length x_reference = 0.01 "Contraction to which thinning, stiffening and hardening refer";
  constant Types.Length y_smooth = 2e-4 "Load over which relaxation and recovery change roles";
  Real hard[3](each unit="1") "Factor on the times that grows with what has relaxed";
  Real by[3](each unit="1") "Factor on the times: 1 in relaxation, recovery where the load has fallen";
  Real s(unit="1") = 8*x/L0 - 1 "Contraction beyond the reference, an eighth of the length, by the reference";
  Real load[3](each unit="m") "Contractions that linear springs would need for the forces";
  Real quick(unit="1") = exp(warm*(port.T - ambient.T)/T_step) "Factor on the rates";
  Types.Length y = x*exp(s*(a + b*s) + h*log(max(1 + p_gauge/p_reference, q_least)))
    "Contraction that a linear spring would need for the same load";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    q = {y, y, y};
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(q) = zeros(3);
  end if;
equation
  for i in 1:3 loop
    by[i] = 0.5*(1 + recovery) + 0.5*(1 - recovery)*(y - q[i])/sqrt((y - q[i])^2 + y_smooth^2);
    hard[i] = exp(0.5*hardening*log((q[i]^2 + x_reference^2)/x_reference^2));
    hard[i]*by[i]*spread^(i - 1)*tau*der(q[i]) = quick*(y - q[i])*(1 + thinning*((y - q[i])/x_reference)^2);
    load[i] = (y - q[i])*(1 + stiffening*((y - q[i])/x_reference)^2);
  end for;
  f = k_1*load[1] + k_2*load[2] + k_3*load[3];
  annotation (defaultComponentName="creep", Documentation(info="<html>
<p>f = sum of k_i e_i (1 + stiffening e_i^2/(10 mm)^2), e_i = y - q_i, tau_i q_i_dot = (y - q_i) (1 + thinning (y -
q_i)^2/(10 mm)^2), tau_i = tau spread^(i-1), times recovery where y &lt; q_i and times (1 + q_i^2/(10
mm)^2)^(hardening/2), y = x (1 + p_gauge/100 kPa)^h exp(a s + b s^2), s = 8 x/L0 - 1; all rates times exp(warm (T -
T_atm)/10 K). Source: the quasi-linear viscoelasticity of <a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">Fung 1981</a>, where the load that a spring of any law would
carry relaxes by one reduced function of time; that function as in <a
href=\"modelica://PneumaticMuscle.Effects.Creep.FlexibleCreep\">FlexibleCreep</a>, which is the case a = b = h = warm
= hardening = stiffening = 0, recovery = 1; a spring of the element that stiffens beside a plain dashpot (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">Reese and Govindjee 1998</a>); the shift of time by
temperature (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Ferry 1980</a>), here by that of the gas;
filled rubber recovers more slowly than it relaxes; creep slows down with what has crept, as a power of it (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">Findley, Lai and Onaran 1976</a>). Typical as there, a 0 to
1, recovery 1 to 5, hardening 0 to 2.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Creep.FlexibleCreep\">FlexibleCreep</a>, larger (or
smaller) at large contraction than in proportion.</p>
</html>"));
end GeneralCreep;
