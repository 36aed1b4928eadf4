within PneumaticMuscle.Interfaces;
partial model ForceElement "A force between the ends of a muscle that opposes its contraction"
  extends MuscleTerminals;
  extends Icons.ForceLaw;
  Types.Length x "Contraction";
  Types.Velocity v "Speed of contraction";
  Types.Velocity v_slip "Speed by whose sign dry friction acts";
  Types.GaugePressure p_gauge "Gauge pressure";
  Types.Force f "Force that opposes contraction";
  outer Ambient ambient "Surroundings";
protected
  constant Types.Velocity v_branch = 1 "Speed beyond every rounding of a sign";
equation
  x = L0 - (flange_b.s - flange_a.s);
  v = der(x);
  v_slip = v + v_branch*ambient.branch;
  p_gauge = port.p - ambient.p;
  flange_a.f = f;
  flange_b.f = -f;
  port.m_flow = 0;
  port.H_flow = 0;
  annotation (Documentation(info="<html>
<p>The equation that defines f is the only one left to the extending class. The gas port is a pressure tap.</p>
<p>In motion v_slip is the speed v. On a branch of quasi-static points the speed vanishes while its sign does not, and
friction that depends on the sign alone has the limit F_c sgn(v) for v to 0: there v_slip is a large speed of that sign,
by which a rounded sign, tanh(v_slip/v_s) or Dahl's equation, has its full size. What depends on the size of the speed
takes v, which is zero there.</p>
</html>"));
end ForceElement;
