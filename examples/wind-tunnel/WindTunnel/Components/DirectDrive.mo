within WindTunnel.Components;
model DirectDrive "The motors get what is commanded, at once"
  extends Interfaces.Drive;
equation
  L_in = u_in;
  L_out = u_out;
end DirectDrive;
