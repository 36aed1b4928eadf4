within PneumaticMuscle.Pneumatics;
model ProportionalDirectionalValve
  "A proportional valve whose opening to the supply or to the exhaust a voltage commands"
  extends Components.PneumaticsWithSpool(
    inlet(A=A_open*(y - overlap + sqrt((y - overlap)^2 + closed^2))/(2*(1 - overlap))),
    outlet(A=A_open*(sqrt((y + overlap)^2 + closed^2) - y - overlap)/(2*(1 - overlap))));
  Interfaces.Signals.VoltageInput u(start=6) "Command of the valve"
    annotation (Placement(transformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=600e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-110,-50},{-90,-30}})));
  parameter Types.Voltage u_mid(min=-10, max=10) = 5 "Command of the closed valve" annotation (Dialog(group="Signal"));
  parameter Types.Voltage u_full(min=0.1, max=20) = 5 "Command beyond that which opens it fully"
    annotation (Dialog(group="Signal"));
  parameter Real overlap(unit="1", min=0, max=0.5) = 0.02 "Part of the stroke, either way, on which it stays closed"
    annotation (Dialog(group="Flow"));
  parameter Types.Time tau(min=1e-4, max=10) = 5e-3 "Time constant of the spool" annotation (Dialog(group="Dynamics"));
  Real y(unit="1", start=0, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Place of the spool, 1: open to the supply, -1: to the exhaust";
protected
  constant Real closed(unit="1") = 1e-3 "Part of the stroke on which corners are rounded";
  Real commanded(unit="1") "Commanded place of the spool";
  Real wanted(unit="1") "The same within the stroke";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(y) = 0;
  end if;
equation
  commanded = (u - u_mid)/u_full;
  wanted = (sqrt((commanded + 1)^2 + closed^2) - sqrt((commanded - 1)^2 + closed^2))/2;
  tau*der(y) = wanted - y;
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-100,-40}, {-95,-40}, {-95,60}, {-90,60}}, color={0,0,127}));
  annotation (defaultComponentName="valve", Documentation(info="<html>
<p>A spool valve with its own position control (the function of an electro-pneumatic continuous flow control valve,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 10041</a>-1): y = (u - u_mid)/u_full within the stroke,
behind a lag tau, and effective areas in proportion to what y is beyond the overlap, with the flow of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42). An overlap below zero, a valve that
bleeds in the middle, is left out. All sizes are for illustration: take them from the data sheet, or fit them. In the
middle either side bleeds through A_open (sqrt(o^2 + 1e-6) - o)/(2 (1 - o)), o the overlap: 1.3e-5 A_open at 0.02, 5e-4
A_open without any.</p>
</html>"));
end ProportionalDirectionalValve;
