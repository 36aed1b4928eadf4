within WindTunnel.Effects;
model DriveRamp "The electronics of the fans change the load at a limited rate"
  extends Interfaces.Drive;
  extends Interfaces.Effect(final family="drive", final balance="torque");
  parameter Real rate(unit="1/s", min=0.1, max=50, nominal=1) = 2 "Greatest change of the load in a second";
protected
  constant Real L_s(unit="1") = 0.02 "Difference over which the rate sets in";
initial equation
  L_in = u_in;
  L_out = u_out;
equation
  der(L_in) = rate*tanh((u_in - L_in)/L_s);
  der(L_out) = rate*tanh((u_out - L_out)/L_s);
  annotation (Documentation(info="<html><p>Soft start: a limited rate, smoothed at the target. Source: usual in drivers of brushless fans.</p></html>"));
end DriveRamp;
