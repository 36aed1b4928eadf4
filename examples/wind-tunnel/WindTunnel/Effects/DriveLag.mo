within WindTunnel.Effects;
model DriveLag "The electronics of the fans follow their commands late"
  extends Interfaces.Drive;
  extends Interfaces.Effect(final family="drive", final balance="torque");
  parameter Real T(unit="s", min=0.02, max=10, nominal=0.3) = 0.3 "Time constant";
initial equation
  L_in = u_in;
  L_out = u_out;
equation
  T*der(L_in) = u_in - L_in;
  T*der(L_out) = u_out - L_out;
  annotation (Documentation(info="<html><p>First-order lag. Source: the usual filter of a pulse-width signal.</p></html>"));
end DriveLag;
