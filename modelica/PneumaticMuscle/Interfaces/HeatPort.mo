within PneumaticMuscle.Interfaces;
connector HeatPort "Thermal port, with the members of the Modelica Standard Library's"
  Types.Temperature T "Port temperature";
  flow Types.Power Q_flow "Heat flow rate into the component";
end HeatPort;
