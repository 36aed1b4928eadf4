within PneumaticMuscle.Effects.ValveArea;
model GeneralArea "The effective area is any smooth function of pressure ratio, pressures, current and side"
  extends Interfaces.ValveArea;
  extends FamilyMember(final general=true,
    final absent="b_r=0, b_2=0, b_4=0, b_6=0, b_8=0, b_p=0, b_s=0, b_u=0, b_v=0, b_e=0, b_f=0, b_d=0, u_p=0");
  parameter Real b_r(unit="1", min=-1, max=2, nominal=0.1) = 0.1
    "Decrease of the logarithm of the area with the pressure ratio"
    annotation (Dialog(group="Effect"));
  parameter Real b_2(unit="1", min=-2, max=2, nominal=0.2) = 0 "Change of this slope beyond a ratio of 0.2"
    annotation (Dialog(group="Effect"));
  parameter Real b_4(unit="1", min=-2, max=2, nominal=0.2) = 0 "Change of this slope beyond a ratio of 0.4"
    annotation (Dialog(group="Effect"));
  parameter Real b_6(unit="1", min=-3, max=3, nominal=0.2) = 0 "Change of this slope beyond a ratio of 0.6"
    annotation (Dialog(group="Effect"));
  parameter Real b_8(unit="1", min=-4, max=4, nominal=0.2) = 0 "Change of this slope beyond a ratio of 0.8"
    annotation (Dialog(group="Effect"));
  parameter Real b_p(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0 "Decrease with the pressure drop, per 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b_s(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0
    "Increase with the upstream pressure, per 100 kPa beyond 200 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b_u(unit="1", min=-1.5, max=1.5, nominal=0.1) = 0
    "Increase with the current, per 0.35 A beyond 0.35 A"
    annotation (Dialog(group="Effect"));
  parameter Real b_v(unit="1", min=-2, max=2, nominal=0.1) = 0 "Quadratic coefficient of the current"
    annotation (Dialog(group="Effect"));
  parameter Real b_e(unit="1", min=-0.7, max=0.7, nominal=0.1) = 0 "Asymmetry between exhaust and inlet"
    annotation (Dialog(group="Effect"));
  parameter Real b_f(unit="1", min=-0.7, max=0.7, nominal=0.1) = 0
    "Asymmetry between exhaust and inlet with the current, per 0.35 A beyond 0.35 A"
    annotation (Dialog(group="Effect"));
  parameter Real b_d(unit="1", min=-0.5, max=2, nominal=0.3) = 0.05 "Exponent of small pressure drops"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure p_d(min=200, max=1e5, nominal=1e4) = 1e4 "Scale of small pressure drops"
    annotation (Dialog(group="Effect"));
  parameter Types.Current u_p(min=-0.02, max=0.1, nominal=0.01) = 0
    "Holding current of the plunger per 100 kPa of pressure drop"
    annotation (Dialog(group="Effect"));
protected
  constant Real z_smooth = 3e-4 "Relative pressure drop over which the sides change roles";
  constant Real r_smooth = 0.1 "Ratio over which its knots are rounded";
  constant Types.Pressure p_reference = 1e5 "Pressure to which b_p, b_s and u_p refer";
  constant Types.Current u_reference = 0.35 "Current at which DP calibrated the valve";
  Real z[2](each unit="1") "Sizes of the relative pressure drops";
  Real r[2](each unit="1") "Pressure ratios, downstream by upstream";
  Real drop[2](each unit="1") "Sizes of the pressure drops, by the reference";
  Real high[2](each unit="1") "Upstream pressures, by the reference";
  Real loss[2](each unit="1") "What the logarithms of the areas lose with the ratio";
  Real small[2](each unit="1") "What they lose where the drop is small";
  Real gain[2](each unit="1") "What they gain with the currents";
equation
  for i in 1:2 loop
    z[i] = sqrt(Functions.pressureDrop(p_a[i], p_b[i])^2 + z_smooth^2);
    r[i] = 1 - z[i];
    high[i] = max(p_a[i], p_b[i])/p_reference;
    drop[i] = z[i]*high[i];
    loss[i] = b_r*r[i] + b_2*Functions.smoothMax(r[i] - 0.2, r_smooth) + b_4*Functions.smoothMax(r[i] - 0.4, r_smooth)
      + b_6*Functions.smoothMax(r[i] - 0.6, r_smooth) + b_8*Functions.smoothMax(r[i] - 0.8, r_smooth);
    small[i] = b_d*log(1 + p_d/(p_reference*drop[i]));
    gain[i] = (b_u + b_v*(u[i]/u_reference - 1))*(u[i]/u_reference - 1);
    A[i] = C_A*Functions.openingArea(u[i] - u_p*drop[i])*exp(gain[i] - loss[i] - small[i] - b_p*drop[i]
      + b_s*(high[i] - 2) + (if i == 1 then -1 else 1)*(b_e + b_f*(u[i]/u_reference - 1)));
  end for;
  annotation (Documentation(info="<html>
<p>As <a href=\"modelica://PneumaticMuscle.Effects.ValveArea.FlexibleArea\">FlexibleArea</a>, where the logarithm of the
area is a smooth chain of straight lines in the pressure ratio r, with knots at 0.2, 0.4, 0.6 and 0.8, a parabola in the
current, and another for either valve; times (dp/(dp + p_d))^b_d, as a diaphragm that the medium lifts needs a drop,
and a power of the drop is left of a law with another exponent below choking. Source: see there, and
<a href=\"modelica://PneumaticMuscle.Effects.ValveArea.UnequalAreas\">UnequalAreas</a>; a chain of lines in r also says
another law of flow than <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(41), with another
critical ratio (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a> states 0.2 to 0.5 for valves)
or another curve beyond it; that of ISO 6358 with a critical ratio of 0.3 is met within 1 % of what it changes, as are
squares of the ratio and of the current. The subsonic index of ISO 6358 is 0.4 to 0.65 for valves, and
servo-assisted ones state a least drop of 10 to 50 kPa. Typical coefficients below 0.3.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveArea.FlexibleArea\">FlexibleArea</a>.</p>
</html>"));
end GeneralArea;
