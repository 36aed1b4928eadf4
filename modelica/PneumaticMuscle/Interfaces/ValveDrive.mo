within PneumaticMuscle.Interfaces;
partial model ValveDrive "From the commanded currents to the currents that the valves feel"
  extends Icons.Drive;
  input Types.Current u[2] "Commanded currents of the inlet and the exhaust valve";
  Types.Current y[2] "Currents that set the openings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equations of both currents y.</p>
</html>"));
end ValveDrive;
