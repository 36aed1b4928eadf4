within PneumaticMuscle.Effects.FrictionHeat;
model GeneralFrictionHeat "Shares of the work of friction heat the gas, some at once and some through two stores"
  extends Interfaces.FrictionHeat;
  extends FamilyMember(final general=true,
    final absent="share_f=0, share_b=0");
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
  parameter Types.Time tau(min=1e-6, max=20, nominal=0.1) = 0.03 "Time constant of the first heat store"
    annotation (Dialog(group="Effect"));
  parameter Real r(unit="1", min=0.01, max=1, nominal=0.1) = 0.1
    "Ratio of the time constant of the second store to the first"
    annotation (Dialog(group="Effect"));
  parameter Real direct(unit="1", min=0, max=1, nominal=0.3) = 0 "Fraction without a store"
    annotation (Dialog(group="Effect"));
  Types.Power Q(start=0, fixed=dynamics == Types.Dynamics.FixedInitial, nominal=0.1)
    "Heat from the first store to the other one";
  Types.Power Q_o(start=0, fixed=dynamics == Types.Dynamics.FixedInitial, nominal=0.1) "Heat from that to the gas";
protected
  constant Types.Power P_smooth = 1e-4 "Power over which contraction and extension change roles";
  Real side(unit="1") = P_bladder/sqrt(P_bladder^2 + P_smooth^2) "1 in contraction, -1 in extension";
  Types.Power P = 0.5*(share_f*P_fibre*(1 + back_f + (1 - back_f)*side)
    + share_b*P_bladder*(1 - back_b + (1 + back_b)*side)) "Work that becomes heat of the gas";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(Q) = 0;
    der(Q_o) = 0;
  end if;
equation
  tau*der(Q) = P - Q;
  r*tau*der(Q_o) = Q - Q_o;
  heatPort.Q_flow = -direct*P - (1 - direct)*Q_o;
  annotation (Documentation(info="<html>
<p>Q_gas = direct P + (1 - direct) Q_o, r tau Q_o_dot = Q - Q_o, tau Q_dot = P - Q, P as in
<a href=\"modelica://PneumaticMuscle.Effects.FrictionHeat.FlexibleFrictionHeat\">FlexibleFrictionHeat</a>. Source: see
there; heat of fibres that lie in the bladder diffuses through it, which two stores in series say to within a few per
cent, and what rubs in the gas heats it at once. Typical as there.</p>
<p>Fingerprint: as
<a href=\"modelica://PneumaticMuscle.Effects.FrictionHeat.FlexibleFrictionHeat\">FlexibleFrictionHeat</a>.</p>
</html>"));
end GeneralFrictionHeat;
