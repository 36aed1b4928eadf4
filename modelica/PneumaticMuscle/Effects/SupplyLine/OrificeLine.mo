within PneumaticMuscle.Effects.SupplyLine;
model OrificeLine "A narrow place between valves and muscle"
  extends Interfaces.Line;
  extends FamilyMember(final absent="A=5e-6");
  parameter Types.Area A(min=2e-8, max=5e-6, nominal=3e-7) = 3e-7 "Effective area of the narrowest place"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Volume V_fitting = 2e-7 "Volume between valve and line, as small as a fitting can be";
  Laws.Lines.LineGas gas(V=V_fitting, p(start=ambient.p), T(start=ambient.T)) "Gas in the line, at the valve end"
    annotation (Placement(transformation(extent={{-40,30},{0,70}})));
  Pneumatics.Components.Orifice resistance(A=A) "Narrow place"
    annotation (Placement(transformation(extent={{10,-20},{50,20}})));
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    gas.p = port_b.p;
    gas.T = port_b.T;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(gas.p) = 0;
    der(gas.m) = 0;
  end if;
equation
  connect(port_a, gas.port)
    annotation (Line(points={{-100,0}, {-45,0}, {-45,50}, {-40,50}}, color={0,90,160}));
  connect(gas.port, resistance.port_a)
    annotation (Line(points={{-40,50}, {-45,50}, {-45,0}, {10,0}}, color={0,90,160}));
  connect(resistance.port_b, port_b)
    annotation (Line(points={{50,0}, {100,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>Isentropic flow through a second orifice in series with the valve. Source:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42); fittings and short tubes by their sonic
conductance as in <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6358</a>. A fitting's volume of 0.2
mL between the two keeps the pressure there a state. Typical 1e-7 to 2e-6 m2 (an open valve of DP: 2.6e-7); at 5e-6 it
is not felt.</p>
<p>Fingerprint: filling and venting are slower when the valve is wide open and right when it is nearly shut; the
holds are right.</p>
</html>"));
end OrificeLine;
