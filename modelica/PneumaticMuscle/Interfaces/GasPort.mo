within PneumaticMuscle.Interfaces;
connector GasPort "Gas at a pressure and a temperature, with the mass and the enthalpy that flow"
  Types.AbsolutePressure p "Absolute pressure";
  Types.Temperature T "Temperature of the gas that is stored here";
  flow Types.MassFlowRate m_flow "Mass flow rate into the component";
  flow Types.Power H_flow "Enthalpy flow rate into the component";
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Ellipse(extent={{-100,-100}, {100,100}}, lineColor={0,90,160}, fillColor={0,90,160},
    fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Volumes and sources set p and T; resistances set m_flow and H_flow. Two potentials with a flow each keep
every volume explicit and every resistance free of mixing loops.</p>
</html>"));
end GasPort;
