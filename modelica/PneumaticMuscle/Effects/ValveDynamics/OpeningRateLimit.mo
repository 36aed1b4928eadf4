within PneumaticMuscle.Effects.ValveDynamics;
model OpeningRateLimit "The openings of the valves change at a limited rate, another in closing"
  extends Interfaces.ValveOpening(
    A(each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial, each nominal=1e-7));
  extends FamilyMember(final absent="travel=1e-6, ratio=1");
  parameter Types.Time travel(min=1e-6, max=4, nominal=0.1) = 0.1
    "Time of opening from shut to 3.69e-7 m2"
    annotation (Dialog(group="Effect"), __PamCosim(at_min=""));
  parameter Real ratio(unit="1", min=0.05, max=20, nominal=1) = 1 "Ratio of the times of closing and opening"
    annotation (Dialog(group="Effect"));
protected
  constant Types.Area A_reference = 3.69e-7 "Area of DP (62) at 0.35 A, before the factor C_A";
  constant Types.Area A_smooth = 4e-9 "Difference of areas over which opening, rest and closing change roles";
  Real side[2](each unit="1") "1 in opening, -1 in closing";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(A) = zeros(2);
  end if;
equation
  for i in 1:2 loop
    side[i] = (A_set[i] - A[i])/sqrt((A_set[i] - A[i])^2 + A_smooth^2);
    0.5*(1 + ratio + (1 - ratio)*side[i])*travel*der(A[i]) = A_reference*side[i];
  end for;
  annotation (Documentation(info="<html>
<p>A_dot = A_0/travel sgn(A_set - A), in closing A_0/(ratio travel), for either valve, A_0 = 3.69e-7 m2, the sign
rounded over 1 % of A_0. Source: a stepping motor, a worm gear or a pilot stage whose flow is limited moves the spool at
one speed (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Merritt 1967</a>, chapter 7); data sheets state
the time of a full stroke. Typical 20 to 500 ms. A_set has the factor C_A of the valve: at 0.35 A it is C_A A_0. Both
valves are shut before the start.</p>
<p>Fingerprint: the flow grows and falls in straight lines; a small opening takes less time than a large one.</p>
</html>"));
end OpeningRateLimit;
