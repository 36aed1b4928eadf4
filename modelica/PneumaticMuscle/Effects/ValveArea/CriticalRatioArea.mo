within PneumaticMuscle.Effects.ValveArea;
model CriticalRatioArea "The valves choke at another pressure ratio than an ideal nozzle"
  extends Interfaces.ValveArea;
  extends FamilyMember(final absent="b=0.5283");
  parameter Real b(unit="1", min=0.05, max=0.5283, nominal=0.3) = 0.3 "Critical pressure ratio"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.2, 0.5}));
protected
  constant Real z_smooth = 3e-4 "Relative pressure drop over which the sides change roles";
  constant Real gamma = Constants.gamma "Ratio of specific heats";
  constant Real z_critical = 1 - (2/(gamma + 1))^(gamma/(gamma - 1)) "Drop at which the ideal nozzle chokes";
  constant Real N_scale = 2/(gamma - 1)*((gamma + 1)/2)^((gamma + 1)/(gamma - 1)) "Square of the factor in DP (40)";
  Real z[2](each unit="1") "Sizes of the relative pressure drops, kept off zero";
  Real w[2](each unit="1") "The same by those at which the valves choke, at most 1";
  Real r[2](each unit="1") "Pressure ratios, at least that at which the ideal nozzle chokes";
equation
  for i in 1:2 loop
    z[i] = sqrt(Functions.pressureDrop(p_a[i], p_b[i])^2 + z_smooth^2);
    w[i] = min(z[i]/(1 - b), 1);
    r[i] = 1 - min(z[i], z_critical);
    A[i] = C_A*Functions.openingArea(u[i])
      *sqrt(w[i]*(2 - w[i])/(N_scale*r[i]^(2/gamma)*(1 - r[i]^((gamma - 1)/gamma))));
  end for;
  annotation (Documentation(info="<html>
<p>A = A(u) psi(r)/N(r), psi = 1 below the critical ratio b and sqrt(1 - ((r - b)/(1 - b))^2) above it, r =
p_down/p_up, N the isentropic law of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40): the flow
is that of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a>, and as calibrated where both
choke. The quotient is finite at r = 1. Source: ISO 6358 states b for each component; several restrictions in series,
such as port, seat and silencer, choke at a lower ratio than a nozzle. Typical 0.2 to 0.5; at b = 0.5283, the critical
ratio of air, the law is within 0.12 % of the isentropic one.</p>
<p>Fingerprint: the beginning of filling is right and its end too slow; venting is right at high pressure and too slow
at low pressure, from b on.</p>
</html>"));
end CriticalRatioArea;
