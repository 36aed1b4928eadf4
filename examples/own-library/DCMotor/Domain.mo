within DCMotor;
record Domain "Terms for reports in this field"
  constant String balances[:] = {"voltage", "torque"} "Balances, in the order in which they are opened and drawn";
  constant String phases[:, 4] = {{"rad/s", "speeding up", "running steadily", "slowing down"}}
    "Unit of the output that divides a run into phases, and names of its rise, rest and fall";
  constant String axes[:] = {"w", "i"} "Variables that a missing term is drawn against, the telling ones first";
  constant String planes[:, 2] = {{"w", "i"}} "Pairs of variables that a missing term is drawn over";
  constant String tested = "voltages, loads and speeds" "What a tested range is a range of";
end Domain;
