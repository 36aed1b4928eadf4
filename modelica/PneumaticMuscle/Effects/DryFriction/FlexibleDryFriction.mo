within PneumaticMuscle.Effects.DryFriction;
model FlexibleDryFriction "Dry friction that grows with pressure and gives way in two steps"
  extends FamilyMember(final absent="F_0=0, F_p=0");
  parameter Types.Force F_0(min=0, max=500, nominal=5) = 5 "Friction force without pressure"
    annotation (Dialog(group="Effect"));
  parameter Types.Force F_p(min=0, max=500, nominal=5) = 2 "Increase per 100 kPa" annotation (Dialog(group="Effect"));
  parameter Types.Length d(min=4e-5, max=8e-3, nominal=1e-3) = 1e-3 "Elastic travel of the second element"
    annotation (Dialog(group="Effect"));
  parameter Real w_1(unit="1", min=0, max=1, nominal=0.3) = 0.5
    "Weight of the first element, with a tenth of the travel"
    annotation (Dialog(group="Effect"));
  parameter Real rise(unit="1", min=-0.7, max=2, nominal=0.3) = 0 "Relative increase of the friction in slow motion"
    annotation (Dialog(group="Effect"));
  Real h[2](each start=0, each fixed=dynamics <> Types.Dynamics.DynamicFreeInitial, each unit="1", each nominal=1)
    "Forces of both parts by those at which they slip in fast motion";
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which F_p is added";
  constant Types.Velocity v_smooth = 1e-6 "Speed below which the size of v is rounded";
  constant Types.Velocity v_slow = 0.01 "Speed scale of the increase";
  constant Real r_smooth(unit="1") = 1e-3 "Share below which its size is rounded";
  Types.Velocity v_size = sqrt(v_slip^2 + v_smooth^2) "Rounded size of the speed";
  Real r[2](each unit="1") = h/(1 + rise*exp(-(v/v_slow)^2)) "The same by those at which they slip now";
equation
  0.1*d*der(h[1]) = v_slip - v_size*r[1]*sqrt(r[1]^2 + r_smooth^2);
  d*der(h[2]) = v_slip - v_size*r[2]*sqrt(r[2]^2 + r_smooth^2);
  f = (F_0 + F_p*Functions.smoothMax(p_gauge/p_reference, 1e-3))*(w_1*h[1] + (1 - w_1)*h[2]);
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = (F_0 + F_p p_gauge/100 kPa) (w_1 h_1 + (1 - w_1) h_2), d_i h_i_dot = v - |v| r_i |r_i|, r_i = h_i/(1 + rise
exp(-(v/10 mm/s)^2)), d_1 = d/10, d_2 = d. Source: the Maxwell-slip model
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12) with two of its elements, each a smooth one
(Dahl's with an exponent of 2), and the normal force that DP (68) and (71) take from the pressure; the curve of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Stribeck 1902</a> by what slow motion adds, within 1 %
where it falls over 15 mm/s. With a small d it is Coulomb's law, within 3 %; Maxwell-slip models of ten elements are met
within 5 %, of four within 7 %, one that slips with a corner after 1 mm within 11 %, over large and small loops under a
rising pressure. Typical F_0 and F_p 1 to 30 N, d 0.1 to 5 mm.</p>
<p>Fingerprint: as
<a href=\"modelica://PneumaticMuscle.Effects.DryFriction.MaxwellSlipFriction\">MaxwellSlipFriction</a>; contraction
against pressure is a loop that widens (or not) with the pressure.</p>
</html>"));
end FlexibleDryFriction;
