within WindTunnel.Interfaces;
partial model Effect "Statements of every effect"
  constant String family "Family of the effect, an identifier";
  constant String balance "Balance in which it acts: torque or sensor";
  constant String absent = "" "Parameter values at which the effect vanishes, such as b=0";
  constant Boolean general = false "General form of its family";
end Effect;
