within PneumaticMuscle.UsersGuide;
partial package FormerNames "Names that classes had in earlier versions; the library inherits them"
  extends Icons.Package;
  package Components "Components of benches"
    extends Icons.Package;
    extends Muscles.Components;
    extends Pneumatics.Components;
    extends Mechanics.Components;
    model Ambient = PneumaticMuscle.Ambient "The surroundings of a bench" annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Ambient\">Ambient</a>.</p>
</html>"));
    model Excitation = PneumaticMuscle.Excitation "What is the same throughout a run"
      annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Excitation\">Excitation</a>.</p>
</html>"));
    annotation (Documentation(info="<html>
<p>They stand in <a href=\"modelica://PneumaticMuscle.Muscles.Components\">Muscles.Components</a>,
<a href=\"modelica://PneumaticMuscle.Pneumatics.Components\">Pneumatics.Components</a> and
<a href=\"modelica://PneumaticMuscle.Mechanics.Components\">Mechanics.Components</a>.</p>
</html>"));
  end Components;
  package Sensors = Instruments.Sensors "Transducers" annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Instruments.Sensors\">Instruments.Sensors</a>.</p>
</html>"));
  package Sources = Examples.Sources "Courses of input signals" annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Examples.Sources\">Examples.Sources</a>.</p>
</html>"));
  package Data = Muscles.Data "Parameter sets of muscles" annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Muscles.Data\">Muscles.Data</a>.</p>
</html>"));
  package Validation = Examples.Validation "Models of what the papers found" annotation (Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.Examples.Validation\">Examples.Validation</a>.</p>
</html>"));
  annotation (Documentation(info="<html>
<p>A model of yours that says <code>PneumaticMuscle.Components.Load</code> or
<code>PneumaticMuscle.Sensors.GaugePressure</code> means the class that stands in
<a href=\"modelica://PneumaticMuscle.Mechanics.Components\">Mechanics.Components</a> or
<a href=\"modelica://PneumaticMuscle.Instruments.Sensors\">Instruments.Sensors</a> now. No class of the library is
written with a former name.</p>
</html>"));
end FormerNames;
