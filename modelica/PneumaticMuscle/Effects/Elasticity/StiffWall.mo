within PneumaticMuscle.Effects.Elasticity;
model StiffWall "A stiff wall takes a part of the pull that comes at once, and the muscle does not push"
  extends FamilyMember(final absent="p_0=0, p_w=0");
  parameter Types.GaugePressure p_0(min=0, max=5e5, nominal=3e4) = 0.3e5
    "Threshold pressure (gauge) at full length"
    annotation (Dialog(group="Effect"));
  parameter Types.Pressure p_w(min=0, max=1e6, nominal=1e5) = 1e5
    "Pressure loss of the wall after it has bent open"
    annotation (Dialog(group="Effect"));
  parameter Real eps_w(unit="1", min=0.005, max=0.06, nominal=0.01) = 0.03
    "Contraction ratio over which the wall bends open"
    annotation (Dialog(group="Effect"));
equation
  f = Functions.wallForce(p_gauge, x, L0, D0, turns, p_0, p_w, eps_w);
  annotation (defaultComponentName="membrane", Documentation(info="<html>
<p>f = min(p_gauge A(L), A(L0) (p_0 + p_w (1 - exp(-eps/eps_w)))), A(L) = (3 L^2 - b^2)/(4 pi n^2). Source: the terms
without pressure that <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sarosi 2012</a> and
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others 2026</a> fit to fluidic muscles,
<a href=\"modelica://PneumaticMuscle.Functions.wallForce\">Functions.wallForce</a>. Typical for such muscles of 10 and
20 mm: p_0 20 to 50 kPa, p_w 100 to 200 kPa, eps_w 0.02 to 0.04. A rubber that is only stretched is not stiffest at
rest.</p>
<p>Fingerprint: nothing moves and nothing pulls below a threshold of pressure; the first percent of contraction cost
much of the pull, the others little beyond what the cylinder loses; a force that does not fall below zero. The pressure
hardly changes.</p>
</html>"));
end StiffWall;
