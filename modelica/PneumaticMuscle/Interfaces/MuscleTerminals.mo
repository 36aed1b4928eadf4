within PneumaticMuscle.Interfaces;
partial model MuscleTerminals "The terminals of a muscle, and the geometry that all its parts share"
  extends VesselTerminals;
  parameter Types.Length L0(min=0.01, max=2) "Length at rest, DP Table 1" annotation (Dialog(group="Geometry"));
  parameter Types.Length D0(min=0.001, max=0.2) "Diameter of the sleeve at rest, DP Table 1"
    annotation (Dialog(group="Geometry"));
  parameter Real turns(unit="1", min=0.1, max=20) "Turns of a fibre about the muscle (n), DP Table 1"
    annotation (Dialog(group="Geometry"));
  parameter Types.Length t_wall(min=1e-5, max=0.02) "Thickness of the bladder (t_b), DP Table 1"
    annotation (Dialog(group="Geometry"));
  Flange flange_a "Load end"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  Flange flange_b "Fixed end"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  annotation (Documentation(info="<html>
<p>Positions are positive in the direction of contraction, with the load end at zero when the muscle is at
rest: contraction x = L0 - (flange_b.s - flange_a.s).</p>
</html>"));
end MuscleTerminals;
