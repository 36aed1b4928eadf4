model Contradiction
  Tanks.Tank left(h_start=1);
  Tanks.Tank right(h_start=2);
equation
  connect(left.port, right.port);
end Contradiction;
