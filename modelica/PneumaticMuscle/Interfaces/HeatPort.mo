within PneumaticMuscle.Interfaces;
connector HeatPort "Thermal port, with the members of the Modelica Standard Library's"
  Types.Temperature T "Port temperature";
  flow Types.Power Q_flow "Heat flow rate into the component";
  annotation (Documentation(info="<html>
<p>Same members as Modelica.Thermal.HeatTransfer.Interfaces.HeatPort: temperature T, flow Q_flow.</p>
</html>"));
end HeatPort;
