within PneumaticMuscle.Effects.DryFriction;
model DahlFriction "Dry friction with a small elastic travel before it slips"
  extends FamilyMember(final absent="F_c=0.01");
  parameter Types.Force F_c(min=0.01, max=500, nominal=5) = 5 "Friction force when slipping"
    annotation (Dialog(group="Effect"));
  parameter Types.Length d(min=1e-5, max=4e-3, nominal=2e-4) = 5e-4 "Elastic travel"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="CoulombFriction"));
  Real r(start=0, fixed=dynamics <> Types.Dynamics.DynamicFreeInitial, unit="1", nominal=1)
    "Share of the friction force";
protected
  constant Types.Velocity v_smooth = 1e-6 "Speed below which the size of v is rounded";
equation
  d*der(r) = v_slip - sqrt(v_slip^2 + v_smooth^2)*r;
  f = F_c*r;
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = F_c r, d r_dot = v - |v| r. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Dahl 1968</a>.
Before it slips, its stiffness is F_c/d. Typical F_c 1 to 30 N, d 0.1 to 2 mm; more than 4 mm of travel is a spring, not
friction.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DryFriction.CoulombFriction\">CoulombFriction</a>; after
a reversal the contraction answers at first as against a spring.</p>
</html>"));
end DahlFriction;
