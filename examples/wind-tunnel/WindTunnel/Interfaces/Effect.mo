within WindTunnel.Interfaces;
partial model Effect "What every effect says of itself"
  constant String family "Family of the effect, an identifier";
  constant String balance "Balance in which it acts: torque or sensor";
  constant String absent = "" "Parameter values at which the effect vanishes, such as b=0";
  constant Boolean general = false "It says whatever its family can";
end Effect;
