within PneumaticMuscle.Mechanics;
model ImposedLength "A drive that imposes the contraction"
  extends Interfaces.Mechanics(shows="F", final F_start=0);
  extends Icons.Motion;
  Interfaces.Flange flange "Load end of the muscle"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  Interfaces.Signals.LengthInput s(start=0.02) "Imposed contraction"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Types.Time tau(min=1e-4, max=1) = 5e-3 "Time constant of the filter" annotation (Dialog(group="Dynamics"));
  parameter Types.Length s_start(min=-1, max=1) = 0 "Contraction at the start" annotation (Dialog(group="Start"));
  Components.ImposedPosition position(tau=tau, s_start=s_start, dynamics=dynamics) "Drive"
    annotation (Placement(transformation(extent={{-30,-30},{30,30}})));
equation
  connect(flange, position.flange)
    annotation (Line(points={{0,100}, {0,30}}, color={0,110,60}));
  connect(s, position.s_wanted)
    annotation (Line(points={{-100,0}, {-30,0}}, color={0,0,127}));
  annotation (defaultComponentName="drive", Documentation(info="<html>
<p>tau^2 x_ddot + 2 tau x_dot + x = s,
<a href=\"modelica://PneumaticMuscle.Mechanics.Components.ImposedPosition\">Components.ImposedPosition</a>: the speed of
the end enters the pressure, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (59), so an imposed
contraction must have a rate. It begins at s_start, whatever the input says.</p>
</html>"));
end ImposedLength;
