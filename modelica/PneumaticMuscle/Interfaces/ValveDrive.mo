within PneumaticMuscle.Interfaces;
partial model ValveDrive "From the commanded currents to the currents that the valves feel"
  extends Icons.Drive;
  input Types.Current u[2] "Commanded currents of the inlet and the exhaust valve";
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.Current y[2] "Currents that set the openings";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equations of both currents y. Where <code>dynamics</code> is
<code>SteadyStateInitial</code> no valve begins shut: it is where its first current has it, also before a dead time is
over.</p>
</html>"));
end ValveDrive;
