within WindTunnel.Effects;
model TachometerLag "The speeds are read late"
  extends Interfaces.Tachometer;
  extends Interfaces.Effect(final family="tachometer", final balance="sensor");
  parameter Real T(unit="s", min=0.01, max=5, nominal=0.2) = 0.2 "Time constant";
initial equation
  y_in = w_in;
  y_out = w_out;
equation
  T*der(y_in) = w_in - y_in;
  T*der(y_out) = w_out - y_out;
  annotation (Documentation(info="<html><p>First-order lag, as of a mean over the last revolutions.</p></html>"));
end TachometerLag;
