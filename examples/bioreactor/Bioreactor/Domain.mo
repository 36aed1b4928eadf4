within Bioreactor;
record Domain "Terms for reports in this field"
  constant String balances[:] = {"growth", "substrate", "biomass"} "Balances, in the order in which they are opened and drawn";
  constant String phases[:, 4] = {{"kg/m3", "accumulation", "steady concentration", "consumption"}}
    "Unit of the output that divides a run into phases, and names of its rise, rest and fall";
  constant String axes[:] = {"S", "X"} "Variables that a missing term is drawn against, the telling ones first";
  constant String planes[:, 2] = {{"S", "X"}} "Pairs of variables that a missing term is drawn over";
  constant String tested = "feeds and concentrations" "What a tested range is a range of";
end Domain;
