within PneumaticMuscle.Interfaces;
partial model GasPortEffect "An effect that takes gas from a vessel or a muscle"
  extends VesselTerminals;
  extends Effect(final balance="mass");
  extends Icons.MassEffect;
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equations of port.m_flow and port.H_flow, positive into the effect.</p>
</html>"));
end GasPortEffect;
