within PneumaticMuscle.CoSimulation;
model ServoController "A PID controller of the contraction that follows a moving target with two valves"
  extends Icons.Signal;
  Interfaces.Signals.LengthInput x(start=0) "Contraction"
    annotation (Placement(transformation(extent={{-110,30},{-90,50}})));
  Interfaces.Signals.LengthInput x_wanted(start=0.02) "Contraction wanted"
    annotation (Placement(transformation(extent={{-110,-50},{-90,-30}})));
  Interfaces.Signals.CurrentOutput u_in "Current of the inlet valve"
    annotation (Placement(transformation(extent={{90,30},{110,50}})));
  Interfaces.Signals.CurrentOutput u_out "Current of the exhaust valve"
    annotation (Placement(transformation(extent={{90,-50},{110,-30}})));
  parameter Real K(unit="A/m", min=0, max=1e5) = 60 "Gain" annotation (Dialog(group="Dynamics"));
  parameter Types.Time T_i(min=1e-3, max=1e6) = 1 "Time constant of the integral" annotation (Dialog(group="Dynamics"));
  parameter Types.Time T_d(min=0, max=10) = 0.09 "Time constant of the derivative"
    annotation (Dialog(group="Dynamics"));
  parameter Types.Time T_f(min=1e-4, max=10) = 0.03 "Time constant of the filter of the derivative"
    annotation (Dialog(group="Dynamics"));
  parameter Real K_v(unit="A.s/m", min=0, max=1e5) = 0 "Current by the speed wanted, ahead of any error"
    annotation (Dialog(group="Dynamics"));
  parameter Types.Current u_open(min=0, max=1) = 0.145 "Current at which a valve begins to open, DP (62)"
    annotation (Dialog(group="Dynamics"));
  parameter Types.Current u_max(min=0, max=1) = 0.35 "Largest current" annotation (Dialog(group="Dynamics"));
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.Length x_filtered(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Contraction behind the filter";
  Types.Length w_filtered(start=0, fixed=dynamics == Types.Dynamics.FixedInitial)
    "Contraction wanted, behind the filter";
  Types.Length i(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Integral of the error by its time constant";
protected
  Types.Velocity v "Speed";
  Types.Velocity v_wanted "Speed wanted";
  Types.Current u "Demand beyond the opening, positive to contract";
  Types.Current u_limited "What of it the valves can do";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(x_filtered) = 0;
    der(w_filtered) = 0;
    der(i) = 0;
  end if;
equation
  v = (x - x_filtered)/T_f;
  v_wanted = (x_wanted - w_filtered)/T_f;
  der(x_filtered) = v;
  der(w_filtered) = v_wanted;
  u = K*(x_wanted - x + i + T_d*(v_wanted - v)) + K_v*v_wanted;
  u_limited = max(-(u_max - u_open), min(u_max - u_open, u));
  T_i*der(i) = x_wanted - x + (u_limited - u)/K;
  u_in = u_open + max(0, u_limited);
  u_out = u_open + max(0, -u_limited);
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8), Documentation(info="<html>
<p>u = K (e + integral of e/T_i + T_d e_dot) + K_v x_w_dot with e = x_w - x and speeds behind a filter T_f; what is
beyond the valves is taken from the integral (back calculation,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Astrom and Hagglund 1995</a>, section 3.5). Both valves
stand where they begin to open, 0.145 A, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62); a
positive u opens the inlet, a negative one the exhaust.</p>
</html>"));
end ServoController;
