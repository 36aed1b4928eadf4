within DCMotor.Effects;
model WarmWinding "The winding warms, and its resistance grows"
  extends Interfaces.Winding;
  extends Interfaces.Effect(final family="winding_heat", final balance="voltage", final absent="C=1e4");
  parameter Real C(unit="J/K", min=0.5, max=1e4, nominal=10) = 50 "Heat capacity of the winding";
  parameter Real G(unit="W/K", min=1e-3, max=10, nominal=0.1) = 0.1 "Conductance to the surroundings";
  constant Real alpha(unit="1/K") = 0.00393 "Temperature coefficient of copper, IEC 60028";
  Real T(unit="K", start=0, fixed=true) "Temperature above the start";
equation
  C*der(T) = R*i^2 - G*T;
  R = R_cold*(1 + alpha*T);
  annotation (Documentation(info="<html>
<p>C der(T) = R i² - G T, R = R_cold (1 + alpha T). Source: IEC 60028 for the coefficient of copper.</p>
<p>Fingerprint: speed and current fall slowly under load at a steady voltage.</p>
</html>"));
end WarmWinding;
