within PneumaticMuscle.Interfaces;
partial model Instrument "An instrument of a rig: a transducer and its measuring channel"
  extends Icons.Sensor;
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: one <code>output</code>, the signal of the rig. With one connector it sits at the
muscle's gas port or load end; with two it lies between the muscle, on the side of the first, and the part that stands
there.</p>
</html>"));
end Instrument;
