within PneumaticMuscle.Pneumatics.Components;
model Supply "An air supply at a given gauge pressure and ambient temperature"
  extends Interfaces.PressureSource;
  extends Icons.GasSource;
  Interfaces.Signals.GaugePressureInput p_gauge "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
equation
  port.p = ambient.p + p_gauge;
  annotation (Documentation(info="<html>
<p>port.p = p_atm + p_gauge, port.T = T_atm, whatever flows.</p>
</html>"));
end Supply;
