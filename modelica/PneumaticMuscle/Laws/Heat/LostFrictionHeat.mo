within PneumaticMuscle.Laws.Heat;
model LostFrictionHeat "The heat of friction does not reach the gas"
  extends Interfaces.FrictionHeat;
equation
  heatPort.Q_flow = 0;
  annotation (Documentation(info="<html>
<p>Q_flow = 0: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (43) leaves out the heat of
friction.</p>
</html>"));
end LostFrictionHeat;
