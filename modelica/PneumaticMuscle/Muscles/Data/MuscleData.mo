within PneumaticMuscle.Muscles.Data;
record MuscleData "Data of a muscle in DP, Tables 1 and 2; defaults are common to both tables"
  extends Icons.Record;
  parameter Types.Length L0 "Initial length of the muscle (L_o)" annotation (Dialog(group="Geometry"));
  parameter Types.Length D0 = 0.02 "Initial diameter of the muscle (D_ref)" annotation (Dialog(group="Geometry"));
  parameter Types.Length d = 0.013 "Diameter of the end connector (D_end)" annotation (Dialog(group="Geometry"));
  parameter Types.Length L_z = 0.008 "Length of a cone" annotation (Dialog(group="Geometry"));
  parameter Types.Length L_y = 0.25 "Length of a fibre; does not close with L0, D0 and turns and is not used"
    annotation (Dialog(group="Geometry"));
  parameter Real turns(unit="1") = 2 "Turns of a fibre (n)" annotation (Dialog(group="Geometry"));
  parameter Real fibres(unit="1") = 216 "Number of fibres (N)" annotation (Dialog(group="Geometry"));
  parameter Types.Length t_wall "Thickness of the bladder (t_b)" annotation (Dialog(group="Geometry"));
  parameter Types.Length t_fibre = 0.254e-3 "Thickness of a fibre (t_f)" annotation (Dialog(group="Geometry"));
  parameter Types.ThermalConductivity k_wall "Thermal conductivity of the bladder (k)"
    annotation (Dialog(group="Heat"));
  parameter Real mu_fb(unit="1") = 0.015 "Coefficient of friction between fibres and bladder"
    annotation (Dialog(group="Friction"));
  parameter Real mu_d(unit="1") = 0.8 "Coefficient of dynamic friction of fibre on fibre"
    annotation (Dialog(group="Friction"));
  parameter Types.Mass m = 2.27 "Hanging mass" annotation (Dialog(group="Load"));
  annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> Tables 1 and 2. They print the conductivity
without a unit; W/(m.K) is meant.</p>
</html>"));
end MuscleData;
