within PneumaticMuscle.Effects.DryFriction;
model GeneralDryFriction "Dry friction of any smooth dependence on pressure, contraction, slow motion and direction"
  extends FamilyMember(final general=true, final absent="F_0=0, F_p=0");
  parameter Types.Force F_0(min=0, max=500, nominal=5) = 5 "Friction force without pressure, at full length"
    annotation (Dialog(group="Effect"));
  parameter Types.Force F_p(min=0, max=500, nominal=5) = 2 "Increase per 100 kPa" annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=0.2, max=3, nominal=1) = 1 "Exponent of the pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Length d(min=4e-5, max=8e-3, nominal=1e-3) = 1e-3 "Elastic travel of the second element"
    annotation (Dialog(group="Effect"));
  parameter Real w_1(unit="1", min=0, max=1, nominal=0.3) = 0.5
    "Weight of the first element, with a tenth of the travel"
    annotation (Dialog(group="Effect"));
  parameter Real n_direct(unit="1", min=0, max=1, nominal=0.3) = 0.5
    "Exponent of the normal load for the force without slip"
    annotation (Dialog(group="Effect"));
  parameter Real rise(unit="1", min=-0.7, max=2, nominal=0.3) = 0 "Relative increase of the friction in slow motion"
    annotation (Dialog(group="Effect"));
  parameter Types.Velocity v_slow(min=5e-4, max=0.2, nominal=0.01) = 0.01 "Speed scale of the increase"
    annotation (Dialog(group="Effect"));
  parameter Real growth(unit="1", min=-1.5, max=1.2, nominal=0.3) = 0 "Relative growth per eighth of the length"
    annotation (Dialog(group="Effect"));
  parameter Real curvature(unit="1", min=-0.8, max=0.25, nominal=0.1) = 0 "Quadratic coefficient of the growth"
    annotation (Dialog(group="Effect"));
  parameter Real asymmetry(unit="1", min=-1, max=1, nominal=0.3) = 0
    "Relative asymmetry between contraction and extension"
    annotation (Dialog(group="Effect"));
  Real h[2](each start=0, each fixed=dynamics <> Types.Dynamics.DynamicFreeInitial, each unit="1", each nominal=1)
    "Forces of both parts by their size at 100 kPa and full length";
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which F_p is added";
  constant Types.Velocity v_smooth = 1e-6 "Speed below which the size of v is rounded";
  constant Real r_smooth(unit="1") = 1e-3 "Share below which its size is rounded";
  constant Real e_reference(unit="1") = 0.125 "Contraction to which the growth refers, by the length";
  Types.Velocity v_size = sqrt(v_slip^2 + v_smooth^2) "Rounded size of the speed";
  Real q(unit="1") = Functions.smoothMax(p_gauge/p_reference, 1e-3) "Gauge pressure by the reference, not below zero";
  Real s(unit="1") = Functions.smoothMax(x/(e_reference*L0), 0.02)
    "Contraction by the reference, zero beyond full length";
  constant Types.Force F_least = 1e-6 "Keeps what is absent a number";
  Real pressing(unit="1") = (F_0 + F_p*exp(n*log(q)) + F_least)/(F_0 + F_p + F_least)*exp(s*(growth + curvature*s))
    "Level of the force by that at 100 kPa and full length";
  Real acting(unit="1") = exp(n_direct*log(pressing)) "Normal load for the force without slip";
  Real slow(unit="1") = 1 + rise*exp(-(v/v_slow)^2) "Level in slow motion by that in fast motion";
  Real r[2](each unit="1") = h*acting/(pressing*slow) "Forces by those at which the parts slip";
equation
  0.1*d*der(h[1]) = v_slip - v_size*r[1]*sqrt(r[1]^2 + r_smooth^2);
  d*der(h[2]) = v_slip - v_size*r[2]*sqrt(r[2]^2 + r_smooth^2);
  f = (F_0 + F_p)*acting*(w_1*h[1] + (1 - w_1)*h[2])*(1 + asymmetry*(w_1*r[1] + (1 - w_1)*r[2]));
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = (F_0 + F_p) a h (1 + asymmetry r), h = w_1 h_1 + (1 - w_1) h_2, r = a h/(N S), d_i h_i_dot = v - |v| r_i |r_i|,
d_1 = d/10, d_2 = d. N = (F_0 + F_p (p_gauge/100 kPa)^n)/(F_0 + F_p) exp(growth s + curvature s^2), s = 8 x/L0, is the
level by what presses the parts together, S = 1 + rise exp(-(v/v_slow)^2) that by the speed, a = N^n_direct.</p>
<p>Source: <a href=\"modelica://PneumaticMuscle.Effects.DryFriction.FlexibleDryFriction\">FlexibleDryFriction</a>, see
there, with a free exponent of the pressure, any growth with the contraction, a free Stribeck speed, and another force
in extension than in contraction. The levels stand inside the equation of the state, as in the LuGre model of <a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">Olsson and others 1998</a>: a part that sticks keeps its
force when the level changes. Laws of muscles take the whole force from the pressure, also where nothing slips (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (68) and (71)): that is n_direct = 1. Typical as
there, v_slow 2 to 50 mm/s, n 0.5 to 2.</p>
<p>Fingerprint: as
<a href=\"modelica://PneumaticMuscle.Effects.DryFriction.FlexibleDryFriction\">FlexibleDryFriction</a>.</p>
</html>"));
end GeneralDryFriction;
