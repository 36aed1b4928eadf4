within PneumaticMuscle.Effects.FrictionHeat;
model FlexibleFrictionHeat
  "Shares of the work of friction heat the gas, at once or later, in extension by another share"
  extends Interfaces.FrictionHeat;
  extends FamilyMember(final absent="share_f=0, share_b=0");
  parameter Real share_f(unit="1", min=0, max=1, nominal=1) = 0.7
    "Fraction of the work of fibre friction that heats the gas"
    annotation (Dialog(group="Effect"));
  parameter Real share_b(unit="1", min=0, max=1, nominal=1) = 0.5 "Share of the work between fibres and bladder"
    annotation (Dialog(group="Effect"));
  parameter Real back_f(unit="1", min=0, max=1, nominal=1) = 1
    "Ratio of the fraction in extension to that in contraction, fibre friction"
    annotation (Dialog(group="Effect"));
  parameter Real back_b(unit="1", min=-1, max=1, nominal=1) = 0 "The same between fibres and bladder; -1 takes heat"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=1e-6, max=20, nominal=0.1) = 0.03 "Time constant of the heat store"
    annotation (Dialog(group="Effect"));
  Types.Power Q(start=0, fixed=dynamics == Types.Dynamics.FixedInitial, nominal=0.1) "Heat to the gas";
protected
  constant Types.Power P_smooth = 1e-4 "Power over which contraction and extension change roles";
  Real side(unit="1") = P_bladder/sqrt(P_bladder^2 + P_smooth^2) "1 in contraction, -1 in extension";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(Q) = 0;
  end if;
equation
  tau*der(Q) = 0.5*(share_f*P_fibre*(1 + back_f + (1 - back_f)*side)
      + share_b*P_bladder*(1 - back_b + (1 + back_b)*side)) - Q;
  heatPort.Q_flow = -Q;
  annotation (Documentation(info="<html>
<p>tau Q_dot = share_f f_ff v + share_b |f_fb v| - Q in contraction; in extension share_f is multiplied by back_f,
share_b by back_b. Source: the friction forces <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>
(68)-(71), whose work DP (43) leaves out; f_fb is a constant as printed, back_b = -1 takes heat from the gas in
extension as <a href=\"modelica://PneumaticMuscle.Effects.FrictionHeat.FrictionHeat\">FrictionHeat</a> does, 1 heats as
friction that dissipates; fibres warm up first and give their heat to the gas with the time constant of a thin cylinder.
Typical shares 0.3 to 1, tau 0.01 to 1 s.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.FrictionHeat.FrictionHeat\">FrictionHeat</a>, a little
later and with another weight of extension.</p>
</html>"));
end FlexibleFrictionHeat;
