within PneumaticMuscle.Examples;
model BlendedValveMuscle "One proportional valve that blends inlet and outlet, DP (8)"
  extends ReviewedBench(muscle(redeclare model Force = Laws.Forces.Gaylord),
    valve(redeclare model Area = Laws.Valves.IttoKogiso), u_in(start=0.2));
  annotation (experiment(StopTime=10, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>At a command of 0.2 A the inlet has 57 % of the area: the pressure settles where both flows are equal.</p>
</html>"));
end BlendedValveMuscle;
