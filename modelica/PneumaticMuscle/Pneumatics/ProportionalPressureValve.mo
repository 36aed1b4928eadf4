within PneumaticMuscle.Pneumatics;
model ProportionalPressureValve "A proportional valve that holds the pressure which a voltage commands"
  extends Components.PneumaticsWithSpool(inlet(A=A_open*(y + sqrt(y^2 + closed^2))/2),
    outlet(A=A_open*(sqrt(y^2 + closed^2) - y)/2));
  Interfaces.Signals.VoltageInput u(start=3) "Command of the valve"
    annotation (Placement(transformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.GaugePressureInput p_supply(start=600e3, min=-101e3) "Gauge pressure of the supply"
    annotation (Placement(transformation(extent={{-110,-50},{-90,-30}})));
  parameter Real k_u(unit="Pa/V", min=1e3, max=1e6, nominal=1e5) = 60e3 "Pressure commanded by a volt"
    annotation (Dialog(group="Signal"));
  parameter Types.Voltage u_0(min=-10, max=10) = 0 "Command of no pressure" annotation (Dialog(group="Signal"));
  parameter Types.Time tau(min=1e-4, max=10) = 0.02 "Time constant of the command"
    annotation (Dialog(group="Dynamics"));
  parameter Types.Pressure p_band(min=100, max=1e6, nominal=1e4) = 10e3
    "Deviation that opens three quarters of the valve"
    annotation (Dialog(group="Flow"));
  parameter Types.GaugePressure p_start(min=-1.01e5, max=1e7) = 0 "Command at the start"
    annotation (Dialog(group="Start"));
  Types.GaugePressure p_wanted(start=p_start, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Pressure that the valve works towards";
  Real y(unit="1") "Opening, 1: to the supply, -1: to the exhaust";
protected
  constant Real closed(unit="1") = 1e-3 "Opening on which the corner of the closed valve is rounded";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(p_wanted) = 0;
  end if;
equation
  tau*der(p_wanted) = k_u*(u - u_0) - p_wanted;
  y = tanh((p_wanted + ambient.p - line.port_a.p)/p_band);
  connect(p_supply, supply.p_gauge)
    annotation (Line(points={{-100,-40}, {-95,-40}, {-95,60}, {-90,60}}, color={0,0,127}));
  annotation (defaultComponentName="valve", Documentation(info="<html>
<p>The valve measures the pressure at its outlet and opens to the supply or to the exhaust by what that lacks of the
command (the function of an electro-pneumatic pressure control valve,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">ISO 10094</a>-1): tau p_wanted_dot = k_u (u - u_0) -
p_wanted, y = tanh((p_wanted - p)/p_band), and the flow through either opening is
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42). So a small deviation is made up for in
proportion, and a large one as fast as the open valve lets the gas through. What it cannot deliver is the pressure above
the supply. The tanh is no maker's curve, and all sizes are for illustration: take them from the data sheet, or fit
them. A closed valve bleeds a two-thousandth of its open area from the supply to the exhaust.</p>
</html>"));
end ProportionalPressureValve;
