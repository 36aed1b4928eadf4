within PneumaticMuscle.Effects.ValveArea;
model BackPressureArea "Back pressure closes the valves a little"
  extends Interfaces.ValveArea;
  extends FamilyMember(final absent="beta=0");
  parameter Real beta(unit="1", min=0, max=0.9, nominal=0.1) = 0.15 "Relative loss of area at equal pressures"
    annotation (Dialog(group="Effect"));
protected
  constant Real z_smooth = 3e-4 "Relative pressure drop over which the sides change roles";
  Real z[2](each unit="1") "Relative pressure drops";
equation
  for i in 1:2 loop
    z[i] = Functions.pressureDrop(p_a[i], p_b[i]);
    A[i] = C_A*Functions.openingArea(u[i])*(1 - beta*(1 - sqrt(z[i]^2 + z_smooth^2)));
  end for;
  annotation (Documentation(info="<html>
<p>A = A(u) (1 - beta p_down/p_up), the ratio of absolute pressures rounded at equal pressures. Source: the discharge
coefficient of a sharp orifice falls with the pressure ratio, from 0.84 to 0.60
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Perry 1949</a>), which is beta = 0.29, and pressure on the
plunger of a proportional valve moves it; <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62) was
measured at one pressure. Typical 0.05 to 0.35.</p>
<p>Fingerprint: the beginning of filling is right and its end too slow; venting is too slow at low pressure.</p>
</html>"));
end BackPressureArea;
