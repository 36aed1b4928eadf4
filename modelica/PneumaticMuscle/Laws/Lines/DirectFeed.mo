within PneumaticMuscle.Laws.Lines;
model DirectFeed "The inlet valve sits on the supply"
  extends Interfaces.Feed;
equation
  connect(port_a, port_b)
    annotation (Line(points={{-100,0}, {100,0}}, color={0,90,160}));
  annotation (Documentation(info="<html>
<p>The two ends are one place: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> take the pressure of
the supply for that before the valve.</p>
</html>"));
end DirectFeed;
