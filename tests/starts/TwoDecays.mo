model TwoDecays "Two decays with start values of their own, of which samples tell the second one badly"
  parameter Real a(min=0, max=100) = 2 "Rate";
  parameter Real g = 0.01 "Share of the second one";
  Real s(start=1, fixed=true, nominal=1);
  Real w(start=1, fixed=true, nominal=1);
  output Real y;
equation
  der(s) = -a*s;
  der(w) = -0.5*w;
  y = s + g*w;
end TwoDecays;
