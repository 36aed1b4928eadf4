within PneumaticMuscle.Effects.DryFriction;
model PressureDryFriction "Dry friction in proportion to gauge pressure, with a small elastic travel"
  extends FamilyMember(final absent="F_p=0");
  parameter Types.Force F_p(min=0, max=500, nominal=5) = 5 "Friction force per 100 kPa when slipping"
    annotation (Dialog(group="Effect"));
  parameter Types.Length d(min=1e-5, max=4e-3, nominal=2e-4) = 5e-4 "Elastic travel"
    annotation (Dialog(group="Effect"));
  Real r(start=0, fixed=dynamics <> Types.Dynamics.DynamicFreeInitial, unit="1", nominal=1)
    "Share of the friction force";
protected
  constant Types.Pressure p_reference = 1e5 "Pressure at which the friction force is F_p";
  constant Types.Velocity v_smooth = 1e-6 "Speed below which the size of v is rounded";
equation
  d*der(r) = v_slip - sqrt(v_slip^2 + v_smooth^2)*r;
  f = F_p*max(p_gauge, 0)/p_reference*r;
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = F_p (p_gauge/100 kPa) r, d r_dot = v - |v| r. Source: fibres rub with a force in proportion to the pressure,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (68), here without the steepness of (69), which makes
it viscous; the travel before they slip by
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Dahl 1968</a>. Typical F_p 1 to 20 N, d 0.1 to 2 mm.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DryFriction.DahlFriction\">DahlFriction</a>, with a loop
that is wider at high pressure.</p>
</html>"));
end PressureDryFriction;
