within PneumaticMuscle.Interfaces;
connector Flange "One-dimensional translational flange, with the members of the Modelica Standard Library's"
  Types.Length s "Absolute position";
  flow Types.Force f "Cut force directed into the flange";
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Rectangle(extent={{-100,-100}, {100,100}}, lineColor={0,110,60}, fillColor={0,110,60},
    fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Same members as Modelica.Mechanics.Translational.Interfaces.Flange_a: position s, flow f.</p>
</html>"));
end Flange;
