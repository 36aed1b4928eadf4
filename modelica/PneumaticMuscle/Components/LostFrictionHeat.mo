within PneumaticMuscle.Components;
model LostFrictionHeat "The heat of friction does not reach the gas"
  extends Interfaces.FrictionHeat;
equation
  heatPort.Q_flow = 0;
end LostFrictionHeat;
