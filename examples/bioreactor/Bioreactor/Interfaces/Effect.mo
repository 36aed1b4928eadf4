within Bioreactor.Interfaces;
partial model Effect "What every effect says of itself"
  constant String family "Family of the effect, an identifier";
  constant String balance "Balance in which it acts: growth, substrate or biomass";
  constant String absent = "" "Parameter values at which the effect vanishes, such as K_S=0";
  constant Boolean general = false "It says whatever its family can";
end Effect;
