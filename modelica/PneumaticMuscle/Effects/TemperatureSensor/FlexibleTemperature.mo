within PneumaticMuscle.Effects.TemperatureSensor;
model FlexibleTemperature "The temperature reading has errors of zero, span and linearity"
  extends Interfaces.TemperatureChannel;
  extends FamilyMember(final absent="offset=0, gain=1, bend=0");
  parameter Real offset(unit="K", min=-50, max=50, nominal=1) = 1 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-2.5, 2.5}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.05 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.3, max=0.3, nominal=0.03) = 0.01 "Quadratic coefficient of the reading, per 20 K"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.02, 0.02}));
protected
  constant Real reference = 20 "What bend refers to";
  outer Ambient ambient "Surroundings";
equation
  y = ambient.T + offset + (u - ambient.T)*(gain + bend*(u - ambient.T)/reference);
  annotation (Documentation(info="<html>
<p>y = T_atm + offset + gain d + bend d^2/(20 K), d = (u - T_atm). Source: zero, span and linearity error, the three
lines of a transducer's data sheet (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 61298</a>-2);
typical 0.5 to 2.5 K, 0.4 to 5 %, 0.1 to 1 % over 40 K.</p>
<p>Fingerprint: the temperature is off by a smooth curve of itself, at rest too; pressure and contraction are right.</p>
</html>"));
end FlexibleTemperature;
