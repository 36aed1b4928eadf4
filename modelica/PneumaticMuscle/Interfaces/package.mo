within PneumaticMuscle;
package Interfaces "Connectors, and what a class must offer to stand in a certain place"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>What joins components (connectors), and what a law must offer to stand in a certain place (partial models).</p>
</html>"));
end Interfaces;
