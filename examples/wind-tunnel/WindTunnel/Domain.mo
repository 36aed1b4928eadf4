within WindTunnel;
record Domain "Terms for reports in this field"
  constant String balances[:] = {"torque", "sensor"} "Balances, in the order in which they are opened and drawn";
  constant String phases[:, 4] = {{"rad/s", "speeding up", "running steadily", "slowing down"}}
    "Unit of the output that divides a run into phases, and names of its rise, rest and fall";
  constant String axes[:] = {"w_in", "w_out"} "Variables that a missing term is drawn against, the telling ones first";
  constant String planes[:, 2] = {{"w_in", "w_out"}} "Pairs of variables that a missing term is drawn over";
  constant String tested = "loads, speeds and hatch positions" "What a tested range is a range of";
  constant String instruments[:, 2] = {{"tachometer", "the reading of the speeds"}}
    "Families that are faults of an instrument, and of which";
end Domain;
