within PneumaticMuscle.Interfaces;
partial model Braid "The sleeve that turns pressure and volume into force and length"
  extends MuscleTerminals;
  extends Icons.Braid;
  Types.Length L "Length";
  Types.Length D "Diameter";
  Types.Volume V "Enclosed volume";
  Types.Force F "Pulling force";
  final parameter Types.Length b = sqrt(L0^2 + (turns*Constants.pi*D0)^2) "Length of a fibre";
  outer Ambient ambient "Surroundings";
equation
  L = flange_b.s - flange_a.s;
  flange_b.f = F;
  flange_a.f = -F;
  port.m_flow = 0;
  port.H_flow = 0;
  annotation (Documentation(info="<html>
<p>The fibre length closes the geometry at rest, b = sqrt(L0^2 + (n pi D0)^2). The fibre length L_y = 0.25 m of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Table 1 does not close with L0, D0 and n of the same
table (they give 0.271 m) and is not used.</p>
<p>Left to the extending class: D, V and F.</p>
</html>"));
end Braid;
