within PneumaticMuscle.Pneumatics;
model Regulator "A proportional pressure regulator: its set point, its lag and its droop"
  extends Interfaces.PneumaticsWithLine(shows="p");
  extends Icons.GasSource;
  Interfaces.Signals.GaugePressureInput p_set(start=200e3, min=-101e3) "Set point of the regulator, gauge"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Time tau(min=1e-4, max=10) = 0.05 "Time constant" annotation (Dialog(group="Dynamics"));
  parameter Real droop(unit="Pa.s/kg", min=1e3, max=1e10, nominal=1e7) = 1e7 "Pressure lost per mass flow delivered"
    annotation (Dialog(group="Flow"));
  parameter Types.GaugePressure p_start(min=-1.01e5, max=1e7) = 0 "Gauge pressure at the start"
    annotation (Dialog(group="Start"));
  Types.GaugePressure p_still(start=p_start, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Gauge pressure that it would hold without flow";
  Components.Supply supply(p_gauge=p_still) "Regulated pressure"
    annotation (Placement(transformation(extent={{-90,-15},{-60,15}})));
  Components.Droop resistance(R=droop) "What the flow costs"
    annotation (Placement(transformation(extent={{-25,-15},{5,15}})));
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(p_still) = 0;
  end if;
equation
  tau*der(p_still) = p_set - p_still;
  connect(supply.port, resistance.port_a)
    annotation (Line(points={{-60,0}, {-25,0}}, color={0,90,160}));
  connect(resistance.port_b, line.port_a)
    annotation (Line(points={{5,0}, {30,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>tau p_dot = p_set - p, the regulator of <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">AM</a> (dynamic
model), and behind it p - p_out = droop m_flow, the flow characteristic of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 6953</a> as a straight line, the same in relief. The
droop at 10 MPa s/kg is 10 kPa per gram a second (some 50 litres a minute); lag and droop are for illustration, the
maker's curves say them. The flow that it can give is not limited.</p>
</html>"));
end Regulator;
