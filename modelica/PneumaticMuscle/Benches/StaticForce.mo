within PneumaticMuscle.Benches;
model StaticForce "Pull of a muscle by pressure and contraction ratio, without any motion, AM Figs. 4-6"
  input Types.GaugePressure p(start=6e5) "Gauge pressure in the muscle";
  input Real eps(start=0.1, unit="1") "Contraction ratio";
  output Types.Force F "Pull of the muscle";
  parameter Types.Length L0(min=0.01, max=2) = 0.3 "Length at rest";
  parameter Types.Length D0(min=0.001, max=0.2) = 0.01 "Diameter at rest";
  parameter Real alpha_0(unit="rad", displayUnit="deg", min=0.1, max=0.9) = 23*Constants.pi/180 "Braid angle at rest";
  replaceable model Braid = Laws.Forces.Kang constrainedby Interfaces.Braid "Law of force without terms of speed";
  inner Components.Ambient ambient "Surroundings";
  Components.Supply supply(p_gauge=p) "Pressure regulator";
  Braid muscle(L0=L0, D0=D0, final turns=L0*tan(alpha_0)/(Constants.pi*D0), t_wall=1e-3) "Muscle";
  Components.Fixed ceiling(s0=L0) "Where the muscle hangs";
  Components.Held held(s=L0*eps) "What holds the load end";
  Sensors.Pull loadCell "Load cell";
equation
  connect(supply.port, muscle.port);
  connect(muscle.flange_a, loadCell.flange_a);
  connect(loadCell.flange_b, held.flange);
  connect(muscle.flange_b, ceiling.flange);
  F = loadCell.F;
  annotation (experiment(StopTime=1, Interval=0.01, Tolerance=1e-6), Documentation(info="<html>
<p>AM, theoretical force equations 1 to 3: Kang's force with q = 1 + 3 exp(-2e-6 P), D0 = 1 cm, 23 degrees, 30 cm. Each sample of
the inputs is a point of a data sheet's grid of force by pressure and contraction, so a grid can be compared and fitted
as a course of time.</p>
<p>About 6 bar and 10 % strain the stated parameters give F = 205.67 N, dF/dP = 5.7239e-4 m2 and dF/dL = 8061.8 N/m. AM
Fig. 7 has 5.7238e-5 and 8061.8: the stiffness is confirmed, the other coefficient is ten times too small in print.</p>
</html>"));
end StaticForce;
