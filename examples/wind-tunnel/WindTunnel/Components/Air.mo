within WindTunnel.Components;
model Air "The air of the tunnel, and its hatch"
  input Real hatch(unit="1") "Opening of the hatch, 0 to 1";
end Air;
