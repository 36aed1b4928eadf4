within DCMotor.Components;
model ConstantWinding "A winding that stays as it is"
  extends Interfaces.Winding;
equation
  R = R_cold;
end ConstantWinding;
