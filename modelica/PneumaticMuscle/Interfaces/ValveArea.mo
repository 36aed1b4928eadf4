within PneumaticMuscle.Interfaces;
partial model ValveArea "From currents to the effective areas of the valves"
  extends Icons.Area;
  input Types.Current u[2] "Currents that set the openings of the inlet and the exhaust valve";
  input Types.AbsolutePressure p_a[2] "Pressures on the sides that gas comes from in normal use";
  input Types.AbsolutePressure p_b[2] "Pressures on the other sides";
  parameter Real C_A(unit="1") "Calibration of the effective area, both valves" annotation (Dialog(group="Flow"));
  Types.Area A[2] "Effective areas";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equations of both areas.</p>
</html>"));
end ValveArea;
