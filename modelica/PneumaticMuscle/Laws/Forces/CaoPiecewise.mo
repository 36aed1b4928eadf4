within PneumaticMuscle.Laws.Forces;
model CaoPiecewise "Linear in contraction and speed, other coefficients above 200 kPa than below, after DP (7)"
  extends Interfaces.Cylinder;
  parameter Types.GaugePressure p_change(min=1e4, max=1e6) = 200e3
    "Gauge pressure at which the slopes by pressure change"
    annotation (Dialog(group="Law"));
  parameter Types.Force F_0(min=-1e3, max=1e3) = 0 "F at no pressure" annotation (Dialog(group="Law"));
  parameter Types.Area F_1(min=0, max=0.1, nominal=1e-3) = 6e-4 "F per gauge pressure below the change"
    annotation (Dialog(group="Law"));
  parameter Types.Area F_2(min=0, max=0.1, nominal=1e-3) = 3e-4 "F per gauge pressure above the change"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalStiffness K_0(min=0, max=1e5) = 500 "Stiffness at no pressure"
    annotation (Dialog(group="Law"));
  parameter Types.Length K_1(min=-1, max=1, nominal=1e-3) = 4e-3 "Stiffness per gauge pressure below the change"
    annotation (Dialog(group="Law"));
  parameter Types.Length K_2(min=-1, max=1, nominal=1e-3) = 2e-3 "Stiffness per gauge pressure above the change"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalDamping B_0(min=0, max=1e4) = 50 "Damping at no pressure"
    annotation (Dialog(group="Law"));
  parameter Real B_1(unit="N.s/(m.Pa)", min=-0.1, max=0.1, nominal=1e-4) = 2e-4
    "Damping per gauge pressure below the change"
    annotation (Dialog(group="Law"));
  parameter Real B_2(unit="N.s/(m.Pa)", min=-0.1, max=0.1, nominal=1e-4) = 1e-4
    "Damping per gauge pressure above the change"
    annotation (Dialog(group="Law"));
  Types.Length x = L0 - L "Contraction";
  Types.Velocity v = der(x) "Speed of contraction";
protected
  constant Types.GaugePressure p_smooth = 1e3 "Pressure over which the slopes change";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Types.GaugePressure p_2 = Functions.smoothMax(p_gauge - p_change, p_smooth) "Gauge pressure above the change";
  Types.GaugePressure p_1 = p_gauge - p_2 "Gauge pressure up to the change";
equation
  F = F_0 + F_1*p_1 + F_2*p_2 - (K_0 + K_1*p_1 + K_2*p_2)*x - (B_0 + B_1*p_1 + B_2*p_2)*v;
  annotation (Documentation(info="<html>
<p>Cao's second model: one equation up to 200 kPa and one above, where the measured coefficients change their slope
abruptly (text after <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (7)). Continuous at the change,
its corner rounded over 1 kPa. No coefficients are given; the defaults are there to be fitted.</p>
</html>"));
end CaoPiecewise;
