within WindTunnel.Components;
model DirectTachometer "The speeds are read as they are"
  extends Interfaces.Tachometer;
equation
  y_in = w_in;
  y_out = w_out;
end DirectTachometer;
