within PneumaticMuscle.Interfaces;
partial model TemperatureChannel "From what a transducer of temperature gives to what is recorded"
  extends Icons.Channel;
  Interfaces.Signals.TemperatureInput u "What the transducer gives"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Interfaces.Signals.TemperatureOutput y "What is recorded"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  annotation (Documentation(info="<html>
<p>The measuring channel behind a transducer: amplifier, filter, converter. Left to the extending class: the equation of
y.</p>
</html>"));
end TemperatureChannel;
