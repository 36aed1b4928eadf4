within PneumaticMuscle.Interfaces;
partial model FrictionHeat "What becomes of the work that friction dissipates in the muscle"
  extends Icons.HeatOfFriction;
  HeatPort heatPort "Gas in the muscle"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  input Types.Power P_fibre "Power of the friction of fibre on fibre";
  input Types.Power P_bladder "Power of the friction between fibres and bladder";
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of heatPort.Q_flow, positive out of the gas.</p>
</html>"));
end FrictionHeat;
