within DCMotor.Interfaces;
partial model Effect "Statements of every effect"
  constant String family "Family of the effect, an identifier";
  constant String balance "Balance in which it acts: voltage or torque";
  constant String absent = "" "Parameter values at which the effect vanishes, such as k=0";
  constant Boolean general = false "General form of its family";
end Effect;
