within PneumaticMuscle.Laws.Forces;
model Reynolds "Contractile element, spring and damper in parallel, all linear in pressure, DP (6)"
  extends Interfaces.Cylinder;
  parameter Types.Force F_0(min=-1e3, max=1e3) = 0 "Contractile force at no pressure" annotation (Dialog(group="Law"));
  parameter Types.Area F_1(min=0, max=0.1, nominal=1e-3) = 6e-4 "Contractile force per gauge pressure"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalStiffness K_0(min=0, max=1e5) = 500 "Stiffness at no pressure"
    annotation (Dialog(group="Law"));
  parameter Types.Length K_1(min=0, max=1, nominal=1e-3) = 4e-3 "Stiffness per gauge pressure"
    annotation (Dialog(group="Law"));
  parameter Types.TranslationalDamping B_0(min=0, max=1e4) = 50 "Damping in contraction at no pressure"
    annotation (Dialog(group="Law"));
  parameter Real B_1(unit="N.s/(m.Pa)", min=-0.1, max=0.1, nominal=1e-4) = 2e-4
    "Damping in contraction per gauge pressure"
    annotation (Dialog(group="Law"));
  parameter Real r(unit="1", min=0, max=2) = 0.6 "Damping in relaxation by that in contraction"
    annotation (Dialog(group="Law"));
  Types.Length y = L0 - L "Contraction";
  Types.Velocity v = der(y) "Speed of contraction";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
protected
  constant Types.Velocity v_smooth = 1e-4 "Speed over which the damping changes";
  Types.TranslationalDamping B = (B_0 + B_1*p_gauge)*(1 + r + (1 - r)*tanh(v/v_smooth))/2 "Damping";
equation
  F = F_0 + F_1*p_gauge - (K_0 + K_1*p_gauge)*y - B*v;
  annotation (Documentation(info="<html>
<p>M y_ddot + B y_dot + K y = F_ce - M g, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (6): the
pull is F_ce - K y - B y_dot with F_ce, K and B linear in pressure, and B smaller in relaxation. The mass and its weight
are the load's. Neither paper gives the coefficients; the defaults are of the size of the latex muscle of DP Table 1 and
are there to be fitted. DP say that the model was tried from 55 to 124 kPa; the abstract of its source,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Reynolds and others 2003</a>, says 207 to 621 kPa.</p>
</html>"));
end Reynolds;
