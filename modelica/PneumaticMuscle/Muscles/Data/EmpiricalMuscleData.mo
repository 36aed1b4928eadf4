within PneumaticMuscle.Muscles.Data;
record EmpiricalMuscleData "Data of a muscle in DY, section 2"
  extends Icons.Record;
  parameter Types.Length L0 "Initial length of the muscle (L_o)" annotation (Dialog(group="Geometry"));
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 2 gives the lengths of two muscles.
Diameter, braid angle and all coefficients were measured or identified (section 6.2) and are not printed.</p>
</html>"));
end EmpiricalMuscleData;
