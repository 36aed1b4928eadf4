within PneumaticMuscle.Effects.Leak;
model GeneralLeak
  "Gas escapes by any smooth law of gauge pressure, contraction, speed and temperature, or above a threshold"
  extends Interfaces.MuscleTerminals;
  extends FamilyMember(final general=true, final absent="G=0");
  parameter Real G(unit="kg/(s.Pa)", min=0, max=1e-9, nominal=1e-11) = 1e-11 "Conductance at 100 kPa and full length"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-1, max=2.5, nominal=0.5) = 0 "Exponent of the conductance at 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0
    "Half of what the exponent gains where the pressure grows by e"
    annotation (Dialog(group="Effect"));
  parameter Real g(unit="1", min=-4, max=2, nominal=0.3) = 0
    "What the logarithm of the conductance gains per 100 kPa beyond 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real growth(unit="1", min=-2, max=3, nominal=0.3) = 0.1
    "What it gains with the contraction, per eighth of the length"
    annotation (Dialog(group="Effect"));
  parameter Real bend(unit="1", min=-0.5, max=0.5, nominal=0.1) = 0 "Half of what that gains there"
    annotation (Dialog(group="Effect"));
  parameter Types.GaugePressure p_open(min=0, max=2e5, nominal=5e4) = 5e3 "Gauge pressure above which it opens"
    annotation (Dialog(group="Effect"));
  parameter Real n_T(unit="1", min=-40, max=40, nominal=3) = 0 "Exponent of the temperature of the gas"
    annotation (Dialog(group="Effect"));
  parameter Real n_v(unit="1", min=-1, max=2, nominal=0.3) = 0 "Exponent of the speed where that is large"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which the law equals G p";
  Real q(unit="1") = (port.p - ambient.p)/p_reference "Gauge pressure by the reference";
  constant Real q_smooth(unit="1") = 0.03 "Pressure by the reference over which it opens";
  Real o(unit="1") = p_open/p_reference "Pressure at which it opens, by the reference";
  Real over(unit="1") = q + 0.5*(sqrt((q - o)^2 + q_smooth^2) - sqrt((q + o)^2 + q_smooth^2)) "What q is beyond that";
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
  port.m_flow = G*p_reference*Functions.curvedPower(over, a, b, 0.01)*exp(g*(q - 1) + s*(growth + bend*s)
    + n_T*log(max(port.T, 1.0)/ambient.T) + 0.5*n_v*log(1 + v^2));
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  flange_a.f = 0;
  flange_b.f = 0;
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G 100 kPa r |r|^(a + b ln|r|) exp(g (q - 1) + growth s + bend s^2) (T/T_atm)^n_T (1 + (v/v_0)^2)^(n_v/2),
v_0 = 5 mm/s, q = p_gauge/100 kPa, r = q - p_open/100 kPa beyond p_open and 0 below, rounded over 3 kPa, s = 8 x/L0:
as <a href=\"modelica://PneumaticMuscle.Effects.Leak.FlexibleLeak\">FlexibleLeak</a> from a threshold on, times
exponentials of the pressure and of the contraction and a power of the temperature. A relief valve or a lip opens at a
pressure; viscosity and density of the gas go with its temperature (n_T about -2), and a seal that shrinks ten times
as much as its groove opens in the cold, by the cube of the gap (n_T to -40); one that slides rides up on a film, by
the root of the speed (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Mueller and Nau 1998</a>). Source:
first terms of the expansion of the logarithm of the conductance; lips are pressed shut or open by the pressure, pores
and end fittings open as the bladder is stretched. What pressure presses shut, p exp(-p/p_0), and what opens with the
exponential of the contraction are met exactly, one that opens at 50 kPa within 3 %. Gas flows out where the pressure
is above the ambient one, whatever the coefficients are. Typical as <a
href=\"modelica://PneumaticMuscle.Effects.Leak.FlexibleLeak\">FlexibleLeak</a>, g -1 to 0.5, growth 0 to 1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.FlexibleLeak\">FlexibleLeak</a>, another at
another contraction.</p>
</html>"));
end GeneralLeak;
