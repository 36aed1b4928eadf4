within Bioreactor;
record Domain "How results are told in this field"
  constant String balances[:] = {"growth", "substrate", "biomass"} "Balances, in the order in which they are opened and drawn";
  constant String phases[:, 4] = {{"kg/m3", "accumulation", "steady concentration", "consumption"}}
    "Unit of the output whose course divides a run, and what it is called to rise, to rest and to fall";
  constant String axes[:] = {"S", "X"} "Variables that a missing term is drawn against, the telling ones first";
  constant String planes[:, 2] = {{"S", "X"}} "Pairs of variables that a missing term is drawn over";
  constant String tested = "feeds and concentrations" "What a tested range is a range of";
end Domain;
