within PneumaticMuscle.Effects.DryFriction;
model MaxwellSlipFriction "Dry friction of four elements in parallel that slip one after the other"
  extends FamilyMember(final absent="F_c=0.01");
  parameter Types.Force F_c(min=0.01, max=500, nominal=5) = 5 "Friction force when all slip"
    annotation (Dialog(group="Effect"));
  parameter Types.Length d(min=4e-5, max=8e-3, nominal=1e-3) = 2e-3 "Travel until the last one slips"
    annotation (Dialog(group="Effect"), __PamCosim(at_min="CoulombFriction"));
  Real r[4](each start=0, each fixed=dynamics <> Types.Dynamics.DynamicFreeInitial, each unit="1", each nominal=1)
    "Share of its friction force in each element";
protected
  constant Types.Velocity v_smooth = 1e-6 "Speed below which the size of v is rounded";
  Types.Velocity v_size = sqrt(v_slip^2 + v_smooth^2) "Rounded size of the speed";
equation
  for i in 1:4 loop
    d*0.5^(4 - i)*der(r[i]) = v_slip - v_size*r[i];
  end for;
  f = F_c*sum(r)/4;
  annotation (defaultComponentName="dryFriction", Documentation(info="<html>
<p>f = sum F_i, four elements that carry F_c/4 each and slip after d/8, d/4, d/2 and d. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (12), after
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Vo-Minh and others 2011</a>, where four elements give the
hysteresis of one muscle; each is a smooth one (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Dahl
1968</a>), so that slip has no corner.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.DryFriction.DahlFriction\">DahlFriction</a>; the loop is
rounded over a longer travel and small loops inside the large one are narrower. Typical F_c 1 to 30 N, d 0.5 to 5 mm;
more than 8 mm of travel is a spring, not friction.</p>
</html>"));
end MaxwellSlipFriction;
