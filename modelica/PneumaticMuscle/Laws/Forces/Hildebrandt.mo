within PneumaticMuscle.Laws.Forces;
model Hildebrandt "A one-way cylinder whose area depends on contraction, against a spring"
  extends Interfaces.PullingSleeve;
  parameter Types.Area a_0(min=0, max=0.1, nominal=1e-3) = 2.6208e-3 "Area at rest" annotation (Dialog(group="Law"));
  parameter Types.Area a_1(min=-1, max=1, nominal=1e-3) = -1.0092e-2 "Area by contraction ratio"
    annotation (Dialog(group="Law"));
  parameter Types.Area a_2(min=-1, max=1, nominal=1e-2) = 8.143e-3 "Area by its square"
    annotation (Dialog(group="Law"));
  parameter Types.Force f_0(min=-1e4, max=1e4) = 113.54 "Force of the spring at rest" annotation (Dialog(group="Law"));
  parameter Types.Force f_1(min=-1e6, max=1e6, nominal=1e3) = 6130.7 "Its force by contraction ratio"
    annotation (Dialog(group="Law"));
  parameter Types.Force f_2(min=-1e7, max=1e7, nominal=1e4) = -57825 "Its force by the square"
    annotation (Dialog(group="Law"));
  parameter Types.Force f_3(min=-1e8, max=1e8, nominal=1e5) = 168406 "Its force by the cube"
    annotation (Dialog(group="Law"));
equation
  F_law = p_gauge*(a_0 + eps*(a_1 + a_2*eps)) - (f_0 + eps*(f_1 + eps*(f_2 + f_3*eps)));
  annotation (Documentation(info="<html>
<p>F = p A(eps) - f(eps), both polynomials: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Hildebrandt and
others 2005</a>, a one-way cylinder that moves against a spring, its pull approximated by polynomials, as
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DY</a> section 1 describes it. The paper was not at hand,
so the degrees, two and three, are chosen here: with them the law leaves 4.2 N rms of Table A1 of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, a DMSP-20 of 300 mm, and 1.3 N
of Table A2. Defaults: that fit to Table A1. Not below zero here.</p>
</html>"));
end Hildebrandt;
