within PneumaticMuscle.Interfaces;
partial model ValveOpening "From the areas that the currents set to those that the gas finds"
  extends Icons.Valve;
  input Types.Area A_set[2]
    "Areas that the inlet and the exhaust valve have in the end, by their currents and pressures";
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.Area A[2] "Effective areas at this moment";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equations of both areas.
<a href=\"modelica://PneumaticMuscle.Interfaces.ValveDrive\">Interfaces.ValveDrive</a> stands before the law of the
area, whose threshold hides what currents below it do; this stands behind the law. <code>dynamics</code> as there.</p>
</html>"));
end ValveOpening;
