within PneumaticMuscle.Laws.Frictions;
model LoadAndRate "Friction by static load and frequency of the excitation, DY (10)-(11)"
  extends CoulombViscous(final c_v=a*excitation.F_load*b_f*excitation.frequency);
  parameter Types.Time a(min=0, max=100) = 0.5 "Coefficient of the load" annotation (Dialog(group="Law"));
  parameter Types.Time b_f(min=0, max=100) = 0.3 "Coefficient of the frequency (b)" annotation (Dialog(group="Law"));
protected
  outer Excitation excitation "Load and frequency of the run";
  annotation (Documentation(info="<html>
<p>F_hys = c_c sign(eps_dot) + gamma_F gamma_f eps_dot, gamma_F = a F, gamma_f = b f,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> (10)-(11). Frequency and load are constants of a
run. a and b stand only in the product a b: no measurement can separate them, and a fit of both says so. Keep one of
them fixed, or use
<a href=\"modelica://PneumaticMuscle.Effects.RateFriction.LoadFrequencyFriction\">LoadFrequencyFriction</a>,
whose parameter is the product. DY give no values; these are for illustration.</p>
</html>"));
end LoadAndRate;
