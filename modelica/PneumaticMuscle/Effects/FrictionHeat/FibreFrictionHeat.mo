within PneumaticMuscle.Effects.FrictionHeat;
model FibreFrictionHeat "The work of friction of fibre on fibre heats the gas"
  extends Interfaces.FrictionHeat;
  extends FamilyMember(final absent="eta=0");
  parameter Real eta(unit="1", min=0, max=1, nominal=1) = 0.9 "Fraction of the work that heats the gas"
    annotation (Dialog(group="Effect"));
equation
  heatPort.Q_flow = -eta*P_fibre;
  annotation (Documentation(info="<html>
<p>Q_flow = eta f_ff v. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (68)-(69), whose
work is positive both ways. Typical 0.3 to 1.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.FrictionHeat.FrictionHeat\">FrictionHeat</a>, with
heating in extension as well as in contraction, in proportion to the square of slow speeds.</p>
</html>"));
end FibreFrictionHeat;
