within PneumaticMuscle.Effects.TemperatureSensor;
model GeneralTemperature "The temperature reading is any smooth function of the temperature"
  extends Interfaces.TemperatureChannel;
  extends FamilyMember(final general=true, final absent="offset=0, gain=1, bend=0, c=0, d=0");
  parameter Real offset(unit="K", min=-50, max=50, nominal=1) = 1 "Offset of the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-2.5, 2.5}));
  parameter Real gain(unit="1", min=0.5, max=2, nominal=1) = 1.05 "Factor on the reading"
    annotation (Dialog(group="Effect"), __PamCosim(typical={0.95, 1.05}));
  parameter Real bend(unit="1", min=-0.5, max=0.5, nominal=0.03) = 0.01 "Coefficient of the second power, per 20 K"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.02, 0.02}));
  parameter Real c(unit="1", min=-0.3, max=0.3, nominal=0.03) = 0 "Coefficient of the third power, per 20 K squared"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.0065, 0.0065}));
  parameter Real d(unit="1", min=-0.1, max=0.1, nominal=0.01) = 0 "Coefficient of the fourth power, per 20 K cubed"
    annotation (Dialog(group="Effect"), __PamCosim(typical={-0.0026, 0.0026}));
protected
  constant Real reference(unit="K") = 20 "What the coefficients refer to";
  Real w(unit="1") "Difference from ambient by the reference";
  outer Ambient ambient "Surroundings";
equation
  w = (u - ambient.T)/reference;
  y = ambient.T + offset + reference*w*(gain + w*(bend + w*(c + d*w)));
  annotation (Documentation(info="<html>
<p>y = T_atm + offset + 20 K (gain w + bend w^2 + c w^3 + d w^4), w = (u - T_atm)/20 K. Source: zero, span and linearity
error of a transducer's data sheet, the last as a polynomial, as the tables of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">IEC 60584</a>-1 are. Typical as
<a href=\"modelica://PneumaticMuscle.Effects.TemperatureSensor.FlexibleTemperature\">FlexibleTemperature</a>, each power
1 % of 40 K at most.</p>
<p>Fingerprint: as
<a href=\"modelica://PneumaticMuscle.Effects.TemperatureSensor.FlexibleTemperature\">FlexibleTemperature</a>.</p>
</html>"));
end GeneralTemperature;
