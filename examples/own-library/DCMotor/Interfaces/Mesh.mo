within DCMotor.Interfaces;
connector Mesh "A loop of a circuit: all its parts carry one current, and their voltages add up to zero"
  Real i(unit="A") "Current";
  flow Real v(unit="V") "Voltage that a part takes";
end Mesh;
