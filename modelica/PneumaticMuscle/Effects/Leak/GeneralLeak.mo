within PneumaticMuscle.Effects.Leak;
model GeneralLeak
  "Gas escapes by any smooth law of gauge pressure, contraction, speed and temperature, or above a threshold"
  extends Interfaces.MuscleTerminals;
  extends ThresholdLeak(final general=true);
  parameter Real growth(unit="1", min=-2, max=3, nominal=0.3) = 0.1
    "Increase with contraction, per eighth of the length"
    annotation (Dialog(group="Effect"));
  parameter Real bend(unit="1", min=-0.5, max=0.5, nominal=0.1) = 0 "Quadratic coefficient of the increase"
    annotation (Dialog(group="Effect"));
  parameter Real n_v(unit="1", min=-1, max=2, nominal=0.3) = 0 "Exponent of large speeds"
    annotation (Dialog(group="Effect"));
protected
  Real s(unit="1") = 8*(1 - (flange_b.s - flange_a.s)/L0) "Contraction by an eighth of the length";
  Types.Length x_late "Contraction a moment ago";
  constant Types.Time t_moment = 5e-3 "How long ago";
  constant Types.Velocity v_reference = 5e-3 "Speed from which on the conductance follows its power";
  Real v(unit="1") = (L0*s/8 - x_late)/(t_moment*v_reference) "Speed by its reference";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    x_late = L0*s/8;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(x_late) = 0;
  end if;
equation
  t_moment*der(x_late) = L0*s/8 - x_late;
  driving = q;
  further = s*(growth + bend*s) + n_T*warm + 0.5*n_v*log(1 + v^2);
  flange_a.f = 0;
  flange_b.f = 0;
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G 100 kPa r |r|^(a + b ln|r|) exp(g (q - 1) + growth s + bend s^2) (T/T_atm)^n_T (1 + (v/v_0)^2)^(n_v/2),
v_0 = 5 mm/s, s = 8 x/L0: <a href=\"modelica://PneumaticMuscle.Effects.Leak.ThresholdLeak\">ThresholdLeak</a>, times an
exponential of the contraction and powers of temperature and speed. A seal that slides rides up on a film, by the root
of the speed (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Mueller and Nau 1998</a>). Source: first
terms of the expansion of the logarithm of the conductance; pores and end fittings open as the bladder is stretched.
What pressure presses shut, p exp(-p/p_0), and what opens with the exponential of the contraction are met exactly, one
that opens at 50 kPa within 3 %. Typical as <a
href=\"modelica://PneumaticMuscle.Effects.Leak.FlexibleLeak\">FlexibleLeak</a>, growth 0 to 1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.FlexibleLeak\">FlexibleLeak</a>, another at
another contraction.</p>
</html>"));
end GeneralLeak;
