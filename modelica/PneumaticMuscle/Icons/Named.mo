within PneumaticMuscle.Icons;
partial class Named "A component: its name above it"
  annotation (Icon(coordinateSystem(preserveAspectRatio=true, extent={{-100,-100},{100,100}}), graphics={
    Text(extent={{-150,110}, {150,150}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>The name alone; what extends it draws the rest.</p>
</html>"));
end Named;
