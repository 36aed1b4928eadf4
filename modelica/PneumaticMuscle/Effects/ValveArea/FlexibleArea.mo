within PneumaticMuscle.Effects.ValveArea;
model FlexibleArea "The effective area depends on both pressures and on the current by any smooth law"
  extends Interfaces.ValveArea;
  extends FamilyMember(final absent="b_r=0, b_p=0, b_s=0, b_u=0, u_p=0");
  parameter Real b_r(unit="1", min=-1, max=2, nominal=0.1) = 0.1
    "Decrease of the logarithm of the area with the pressure ratio"
    annotation (Dialog(group="Effect"));
  parameter Real b_p(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0 "Decrease with the pressure drop, per 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b_s(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0
    "Increase with the upstream pressure, per 100 kPa beyond 200 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real b_u(unit="1", min=-1.5, max=1.5, nominal=0.1) = 0
    "Increase with the current, per 0.35 A beyond 0.35 A"
    annotation (Dialog(group="Effect"));
  parameter Types.Current u_p(min=-0.02, max=0.1, nominal=0.01) = 0
    "Holding current of the plunger per 100 kPa of pressure drop"
    annotation (Dialog(group="Effect"));
protected
  constant Real z_smooth = 3e-4 "Relative pressure drop over which the sides change roles";
  constant Types.Pressure p_reference = 1e5 "Pressure to which b_p, b_s and u_p refer";
  constant Types.Current u_reference = 0.35 "Current at which DP calibrated the valve";
  Real z[2](each unit="1") "Sizes of the relative pressure drops";
  Real drop[2](each unit="1") "Sizes of the pressure drops, by the reference";
  Real high[2](each unit="1") "Upstream pressures, by the reference";
equation
  for i in 1:2 loop
    z[i] = sqrt(Functions.pressureDrop(p_a[i], p_b[i])^2 + z_smooth^2);
    high[i] = max(p_a[i], p_b[i])/p_reference;
    drop[i] = z[i]*high[i];
    A[i] = C_A*Functions.openingArea(u[i] - u_p*drop[i])
      *exp(b_u*(u[i]/u_reference - 1) - b_r*(1 - z[i]) - b_p*drop[i] + b_s*(high[i] - 2));
  end for;
  annotation (Documentation(info="<html>
<p>A = A(u - u_p (p_up - p_down)/100 kPa) exp(b_u (u/0.35 A - 1) - b_r r - b_p (p_up - p_down)/100 kPa
+ b_s (p_up/100 kPa - 2)), r = p_down/p_up: never negative, whatever the coefficients are. Source: first terms of the
expansion of ln A about <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62) at the current of its
calibration; the ratio moves the discharge coefficient
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Perry 1949</a>), the pressure drop the plunger against its
spring, the upstream pressure the seat. Of what they change at the inlet, straight lines and exponentials of the ratio
and of the drop are met within 1 %, Perry's curve within 5 %, the square of the ratio within 9 %, another curve of area
by current within 11 %, and a factor by the supply's pressure alone within 2 %. Typical -0.3 to 0.3, u_p 0 to 20 mA; the
bounds keep the valves shut without current.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveArea.BackPressureArea\">BackPressureArea</a> or
<a href=\"modelica://PneumaticMuscle.Effects.ValveArea.CurrentOffsetArea\">CurrentOffsetArea</a>; filling and venting
are wrong by a factor that changes on the way.</p>
</html>"));
end FlexibleArea;
