within PneumaticMuscle.Effects.FrictionHeat;
model FrictionHeat "The work of all friction heats the gas"
  extends Interfaces.FrictionHeat;
  extends FamilyMember(final absent="eta=0");
  parameter Real eta(unit="1", min=0, max=1, nominal=1) = 0.9 "Fraction of the work that heats the gas"
    annotation (Dialog(group="Effect"));
equation
  heatPort.Q_flow = -eta*(P_fibre + P_bladder);
  annotation (Documentation(info="<html>
<p>Q_flow = eta (f_ff + f_fb) v. Source: the friction forces
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (68)-(71), whose work DP (43) leaves out. f_fb is a
constant as printed, so it takes heat from the gas in extension. Typical 0.3 to 1: the rest goes outwards through the
sleeve.</p>
<p>Fingerprint: pressure and temperature are a little higher while the muscle contracts, in proportion to
pressure times speed; nothing happens in holds.</p>
</html>"));
end FrictionHeat;
