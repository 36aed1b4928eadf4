within PneumaticMuscle.Effects.DeadVolume;
partial model FamilyMember "Statements of every member of the family"
  extends Interfaces.GasPortEffect(final family="dead_volume");
  extends Icons.DeadVolume;
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equations of port.m_flow and port.H_flow, positive into the effect, and its
parameters.</p>
</html>"));
end FamilyMember;
