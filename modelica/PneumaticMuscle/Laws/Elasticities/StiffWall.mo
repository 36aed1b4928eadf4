within PneumaticMuscle.Laws.Elasticities;
model StiffWall "The wall of a fluidic muscle, which takes a part of the pull"
  extends Interfaces.ForceElement;
  extends Icons.Elasticity;
  parameter Types.GaugePressure p_0(min=0, max=5e5, nominal=3e4) = 0.3e5
    "Threshold pressure (gauge) at full length"
    annotation (Dialog(group="Law"));
  parameter Types.Pressure p_w(min=0, max=1e6, nominal=1e5) = 1e5
    "Pressure loss of the wall after it has bent open"
    annotation (Dialog(group="Law"));
  parameter Real eps_w(unit="1", min=0.005, max=0.06, nominal=0.01) = 0.03
    "Contraction ratio over which the wall bends open"
    annotation (Dialog(group="Law"));
equation
  f = Functions.wallForce(p_gauge, x, L0, D0, turns, p_0, p_w, eps_w);
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Functions.wallForce\">Functions.wallForce</a>, after the terms without pressure
of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Sarosi 2012</a> and
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others 2026</a>. Fitted to the tables that
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a> measured, beside a cylinder
with the geometry of <a href=\"modelica://PneumaticMuscle.Muscles.Data.DMSP10\">Data.DMSP10</a> and
<a href=\"modelica://PneumaticMuscle.Muscles.Data.DMSP20\">DMSP20</a>, it leaves 6.1 N rms of 542 N and 13.4 N of 1654
N. The cylinder alone, its pull scaled at will, leaves 84 N and 150 N.</p>
</html>"));
end StiffWall;
