within WindTunnel.Interfaces;
partial model FanTerminals "The shafts of both fans: an effect that has them too is connected in parallel"
  Shaft intake "Shaft of the intake fan";
  Shaft exhaust "Shaft of the exhaust fan";
end FanTerminals;
