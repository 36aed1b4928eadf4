within PneumaticMuscle.CoSimulation;
model ContractionController "A proportional controller of the contraction with two valves"
  extends Icons.Signal;
  Interfaces.Signals.LengthInput x(start=0) "Contraction"
    annotation (Placement(transformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.LengthInput x_wanted(start=0.02) "Contraction wanted"
    annotation (Placement(transformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.CurrentOutput u_in "Current of the inlet valve"
    annotation (Placement(transformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.CurrentOutput u_out "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{90,-50},{110,-30}})));
  parameter Real K(unit="A/m", min=0, max=1e4) = 40 "Gain" annotation (Dialog(group="Dynamics"));
  parameter Types.Current u_max(min=0, max=1) = 0.35 "Largest current" annotation (Dialog(group="Dynamics"));
  parameter Types.Time tau(min=1e-4, max=10) = 0.02 "Time constant of the filter of the contraction"
    annotation (Dialog(group="Dynamics"));
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.Length x_filtered(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Contraction without noise";
protected
  Types.Current u "Demand, positive to contract";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(x_filtered) = 0;
  end if;
equation
  tau*der(x_filtered) = x - x_filtered;
  u = u_max*tanh(K*(x_wanted - x_filtered)/u_max);
  u_in = max(0, u);
  u_out = max(0, -u);
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8), Documentation(info="<html>
<p>tau x_f_dot + x_f = x and u = u_max tanh(K (x_w - x_f)/u_max), which goes to the inlet valve where it is positive and
to the exhaust valve where it is negative. The valves open at 0.145 A,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62), so the load comes to rest within 0.145 A/K of
what is wanted. The wanted contraction acts at once on the currents, the contraction through a filter.</p>
</html>"));
end ContractionController;
