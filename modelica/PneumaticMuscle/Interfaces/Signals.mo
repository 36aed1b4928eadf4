within PneumaticMuscle.Interfaces;
package Signals "Connectors of signals: what is driven and what is read"
  extends Icons.Package;
  connector CurrentInput = input Types.Current "An electric current that comes in"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Types.Current as a connector.</p>
</html>"));
  connector GaugePressureInput = input Types.GaugePressure "A gauge pressure that comes in"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Types.GaugePressure as a connector.</p>
</html>"));
  connector LengthInput = input Types.Length "A length or position that comes in"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Types.Length as a connector.</p>
</html>"));
  connector ForceInput = input Types.Force "A force that comes in"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Types.Force as a connector.</p>
</html>"));
  connector TemperatureInput = input Types.Temperature "A temperature that comes in"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Types.Temperature as a connector.</p>
</html>"));
  connector VoltageInput = input Types.Voltage "A voltage that comes in"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Types.Voltage as a connector.</p>
</html>"));
  connector RealInput = input Real "A number that comes in, as in Modelica.Blocks.Interfaces"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={0,0,127}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>input Real as a connector.</p>
</html>"));
  connector CurrentOutput = output Types.Current "An electric current that goes out"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={255,255,255}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>output Types.Current as a connector.</p>
</html>"));
  connector GaugePressureOutput = output Types.GaugePressure "A gauge pressure that goes out"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={255,255,255}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>output Types.GaugePressure as a connector.</p>
</html>"));
  connector LengthOutput = output Types.Length "A length or position that goes out"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={255,255,255}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>output Types.Length as a connector.</p>
</html>"));
  connector ForceOutput = output Types.Force "A force that goes out"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={255,255,255}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>output Types.Force as a connector.</p>
</html>"));
  connector TemperatureOutput = output Types.Temperature "A temperature that goes out"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={255,255,255}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>output Types.Temperature as a connector.</p>
</html>"));
  connector RealOutput = output Real "A number that goes out, as in Modelica.Blocks.Interfaces"
    annotation (Icon(graphics={Polygon(points={{-100,100}, {100,0}, {-100,-100}}, lineColor={0,0,127},
      fillColor={255,255,255}, fillPattern=FillPattern.Solid)}), Documentation(info="<html>
<p>output Real as a connector.</p>
</html>"));
  annotation (Documentation(info="<html>
<p>Short classes of the built-in type Real, as RealInput and RealOutput of Modelica.Blocks.Interfaces are: blocks of the
Modelica Standard Library connect to them (plug compatibility, Modelica 3.6, section 9.1). A variable of such a class is
an input or output of the same name as one declared with the prefix <code>input</code> or <code>output</code>; a binding
equation, <code>valve(u_in=u_in)</code>, does what a connection does.</p>
</html>"));
end Signals;
