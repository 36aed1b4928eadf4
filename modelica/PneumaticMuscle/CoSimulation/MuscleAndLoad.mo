within PneumaticMuscle.CoSimulation;
model MuscleAndLoad "A muscle without its gas that lifts a hanging mass; the pressure comes from outside"
  extends Icons.Bench;
  extends Benches.BaseClasses.LiftedMass(redeclare Sleeve muscle);
  input Types.GaugePressure p(start=0) "Gauge pressure in the muscle";
  output Types.Length x "Contraction";
  output Types.Volume V "Volume of the gas";
  output Types.VolumeFlowRate V_flow "Rate of the volume";
  output Types.Area A "Area of the wall that exchanges heat with the gas";
  inner Ambient ambient "Surroundings"
    annotation (Placement(transformation(extent={{-80,40},{-40,80}})));
  Pneumatics.Components.Supply gas(p_gauge=p) "Gas at the pressure that comes from outside"
    annotation (Placement(transformation(extent={{-80,-20},{-40,20}})));
equation
  connect(gas.port, muscle.port)
    annotation (Line(points={{-40,0}, {30,0}}, color={0,90,160}));
  x = load.s;
  V = muscle.braid.V;
  V_flow = der(V);
  A = muscle.A;
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-8),
    __PamCosim(terminals="gas: p, V, V_flow, A"), Documentation(info="<html>
<p><a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), (16)-(17), (68)-(71). Of the outputs none
depends at once on the pressure: they follow from position and speed of the load. Alone, without pressure, the mass
rests on the stop.</p>
</html>"));
end MuscleAndLoad;
