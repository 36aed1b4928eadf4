within PneumaticMuscle.Effects.DryFriction;
model GeneralDryFriction "Dry friction of any smooth dependence on pressure, contraction, slow motion and direction"
  extends FamilyMember(final general=true, final absent="F_0=0, F_p=0");
  parameter Types.Force F_0(min=0, max=500, nominal=5) = 5 "Friction force without pressure, at full length"
    annotation (Dialog(group="Effect"));
  parameter Types.Force F_p(min=0, max=500, nominal=5) = 2 "What 100 kPa add to it" annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=0.2, max=3, nominal=1) = 1 "Exponent of the pressure in that"
    annotation (Dialog(group="Effect"));
  parameter Types.Length d(min=4e-5, max=8e-3, nominal=1e-3) = 1e-3 "Travel of the part that slips last"
    annotation (Dialog(group="Effect"));
  parameter Real share(unit="1", min=0, max=1, nominal=0.3) = 0.5 "Share of the part that slips first"
    annotation (Dialog(group="Effect"));
  parameter Real first(unit="1", min=0.03, max=0.6, nominal=0.1) = 0.1 "Travel of that part by the other's"
    annotation (Dialog(group="Effect"));
  parameter Real rise(unit="1", min=-0.7, max=2, nominal=0.3) = 0 "What slow motion adds, by that of fast motion"
    annotation (Dialog(group="Effect"));
  parameter Types.Velocity v_slow(min=5e-4, max=0.2, nominal=0.01) = 0.01 "Speed that is slow in this sense"
    annotation (Dialog(group="Effect"));
  parameter Real growth(unit="1", min=-1.5, max=1.2, nominal=0.3) = 0 "Relative growth per eighth of the length"
    annotation (Dialog(group="Effect"));
  parameter Real bow(unit="1", min=-0.8, max=0.25, nominal=0.1) = 0 "Half of the change of that growth"
    annotation (Dialog(group="Effect"));
  parameter Real side(unit="1", min=-1, max=1, nominal=0.3) = 0 "What contraction gains and extension loses, by it"
    annotation (Dialog(group="Effect"));
  Real r[2](each start=0, each fixed=dynamics <> Types.Dynamics.DynamicFreeInitial, each unit="1", each nominal=1)
    "Shares of their forces that both parts carry";
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which F_p is added";
  constant Types.Velocity v_smooth = 1e-6 "Speed below which the size of v is rounded";
  constant Real r_smooth(unit="1") = 1e-3 "Share below which its size is rounded";
  constant Real e_reference(unit="1") = 0.125 "Contraction to which the growth refers, by the length";
  Types.Velocity v_size = sqrt(v_slip^2 + v_smooth^2) "Rounded size of the speed";
  Real q(unit="1") = Functions.smoothMax(p_gauge/p_reference, 1e-3) "Gauge pressure by the reference, not below zero";
  Real s(unit="1") = Functions.smoothMax(x/(e_reference*L0), 0.02)
    "Contraction by the reference, zero beyond full length";
  Real carried(unit="1") = share*r[1] + (1 - share)*r[2] "Share of the whole force";
equation
  first*d*der(r[1]) = v_slip - v_size*r[1]*sqrt(r[1]^2 + r_smooth^2);
  d*der(r[2]) = v_slip - v_size*r[2]*sqrt(r[2]^2 + r_smooth^2);
  f = (F_0 + F_p*exp(n*log(q)))*exp(s*(growth + bow*s))*carried*(1 + side*carried)*(1 + rise*exp(-(v/v_slow)^2));
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = (F_0 + F_p (p_gauge/100 kPa)^n) exp(growth s + bow s^2) r (1 + side r) (1 + rise exp(-(v/v_slow)^2)), r = share
r_1 + (1 - share) r_2, d_i r_i_dot = v - |v| r_i |r_i|, d_1 = first d, d_2 = d, s = 8 x/L0. Source:
<a href=\"modelica://PneumaticMuscle.Effects.DryFriction.FlexibleDryFriction\">FlexibleDryFriction</a>, see there, with
a free exponent of the pressure, any growth with the contraction, a free Stribeck speed, and another force in extension
than in contraction. Typical as there, v_slow 2 to 50 mm/s, n 0.5 to 2.</p>
<p>Fingerprint: as
<a href=\"modelica://PneumaticMuscle.Effects.DryFriction.FlexibleDryFriction\">FlexibleDryFriction</a>.</p>
</html>"));
end GeneralDryFriction;
