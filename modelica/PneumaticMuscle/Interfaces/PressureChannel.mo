within PneumaticMuscle.Interfaces;
partial model PressureChannel "From what a transducer of pressure gives to what is recorded"
  extends Icons.Channel;
  input Types.GaugePressure u "What the transducer gives";
  Types.GaugePressure y "What is recorded";
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial "How it begins: fixed, at rest, or as nothing else says"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  annotation (Documentation(info="<html>
<p>The measuring channel behind a transducer: amplifier, filter, converter. Left to the extending class: the equation of
y.</p>
</html>"));
end PressureChannel;
