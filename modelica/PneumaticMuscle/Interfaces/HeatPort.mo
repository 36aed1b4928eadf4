within PneumaticMuscle.Interfaces;
connector HeatPort "Thermal port, with the members of the Modelica Standard Library's"
  Types.Temperature T "Port temperature";
  flow Types.Power Q_flow "Heat flow rate into the component";
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={190,30,0}, fillColor={190,30,0},
    fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Same members as Modelica.Thermal.HeatTransfer.Interfaces.HeatPort: temperature T, flow Q_flow.</p>
</html>"));
end HeatPort;
