model Divider "A model that breaks down for some parameter values"
  parameter Real a(min=-10, max=10) = 1 "Below zero the root has no value";
  Real s(start=1, fixed=true);
  output Real y;
equation
  der(s) = -s;
  y = s*sqrt(a);
  annotation (experiment(StopTime=1, Interval=0.1));
end Divider;
