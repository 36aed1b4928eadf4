within PneumaticMuscle.Interfaces;
connector Flange "One-dimensional translational flange, with the members of the Modelica Standard Library's"
  Types.Length s "Absolute position";
  flow Types.Force f "Cut force directed into the flange";
  annotation (Documentation(info="<html>
<p>Same members as Modelica.Mechanics.Translational.Interfaces.Flange_a: position s, flow f.</p>
</html>"));
end Flange;
