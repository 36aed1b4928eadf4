within PneumaticMuscle.Components;
model FibreFriction "Friction of fibre on fibre, DP (68)-(69)"
  extends Interfaces.ForceElement;
  parameter Types.Area A_ff "Area of all crossings of fibres";
  parameter Real mu_d(unit="1") "Coefficient of dynamic friction";
  parameter Real K_f(unit="s/m") "Steepness of the friction curve";
equation
  f = p_gauge*A_ff*mu_d*tanh(K_f*v);
end FibreFriction;
