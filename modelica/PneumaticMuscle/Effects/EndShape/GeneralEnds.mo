within PneumaticMuscle.Effects.EndShape;
model GeneralEnds
  "The pull differs from the cylinder's by any smooth law of contraction, one part of which fades with pressure"
  extends Interfaces.Cylinder;
  extends FamilyMember(final general=true,
    final absent="a_0=0, a_1=0, a_2=0, c_0=0, c_1=0, c_2=0, c_3=0");
  parameter Real a_0(unit="1", min=-0.7, max=0.5, nominal=0.1) = 0 "Decaying excess at full length"
    annotation (Dialog(group="Effect"));
  parameter Real a_1(unit="1", min=-2, max=0.5, nominal=0.1) = -0.05 "Linear coefficient of the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real a_2(unit="1", min=-1, max=0.5, nominal=0.1) = 0 "Quadratic coefficient of the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real s(unit="1", min=0, max=5, nominal=0.5) = 0.5 "Decay rate, per 100 kPa"
    annotation (Dialog(group="Effect"));
  parameter Real w(unit="1", min=0.02, max=2, nominal=0.3) = 0.1
    "Inverse of the final decay exponent; 0.02 is exponential"
    annotation (Dialog(group="Effect"));
  parameter Real c_0(unit="1", min=-0.5, max=0.3, nominal=0.1) = 0 "Constant excess at full length"
    annotation (Dialog(group="Effect"));
  parameter Real c_1(unit="1", min=-1, max=0.3, nominal=0.1) = 0 "Linear coefficient of the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real c_2(unit="1", min=-1, max=0.4, nominal=0.1) = 0 "Quadratic coefficient of the contraction"
    annotation (Dialog(group="Effect"));
  parameter Real c_3(unit="1", min=-0.5, max=0.2, nominal=0.1) = 0 "Cubic coefficient of the contraction"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Pressure p_reference = 1e5 "Pressure to which s refers";
  constant Real e_reference(unit="1") = 0.25 "Strain at which the coefficients count fully";
  constant Real e_end(unit="1") = 1.7 "Contraction beyond all that a muscle reaches, where the excess ends";
  Types.GaugePressure p_gauge = port.p - ambient.p "Gauge pressure";
  Real q(unit="1") = Functions.smoothMax(p_gauge/p_reference, 1e-3) "Pressure by its reference, not below zero";
  Real e(unit="1") = (1 - L/L0)/e_reference "Contraction";
  Real fade(unit="1") = exp(-log(1 + s*w*q)/w) "1 without pressure";
  Real excess(unit="1") = ((a_0 + e*(a_1 + a_2*e))*fade + c_0 + e*(c_1 + e*(c_2 + c_3*e)))/(1 + (e/e_end)^24)
    "By the pull at full length";
equation
  F = p_gauge*(3*L^2 - b^2 + excess*(3*L0^2 - b^2))/(4*Constants.pi*turns^2);
  annotation (Documentation(info="<html>
<p>F = p_gauge (A(L) + A(L0) ((a_0 + a_1 e + a_2 e^2) (1 + s w q)^(-1/w) + c_0 + c_1 e + c_2 e^2 + c_3 e^3)), q =
p_gauge/100 kPa, e = strain/0.25. Source:
<a href=\"modelica://PneumaticMuscle.Effects.EndShape.FlexibleEnds\">FlexibleEnds</a>, see there; ends that keep their
shape and a pull that comes with pressure, be it exponentially (w near 0), be it as 1/(1 + p/p_0) (w = 1), together.
Fillets of a tenth of the strain are met within 3 % of what they change. Typical coefficients below 0.3, s 0.3 to 3.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.EndShape.FlexibleEnds\">FlexibleEnds</a>.</p>
</html>"));
end GeneralEnds;
