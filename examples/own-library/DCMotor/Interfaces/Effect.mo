within DCMotor.Interfaces;
partial model Effect "What every effect says of itself"
  constant String family "Family of the effect, an identifier";
  constant String balance "Balance in which it acts: voltage or torque";
  constant String absent = "" "Parameter values at which the effect vanishes, such as k=0";
  constant Boolean general = false "It says whatever its family can";
end Effect;
