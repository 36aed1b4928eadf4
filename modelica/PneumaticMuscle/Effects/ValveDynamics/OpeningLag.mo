within PneumaticMuscle.Effects.ValveDynamics;
model OpeningLag "The openings of the valves follow with a first-order lag"
  extends Interfaces.ValveOpening(
    A(each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial, each nominal=1e-7));
  extends FamilyMember(final absent="tau=1e-6");
  parameter Types.Time tau(min=1e-6, max=2, nominal=0.05) = 0.05 "Time constant" annotation (Dialog(group="Effect"));
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(A) = zeros(2);
  end if;
equation
  for i in 1:2 loop
    tau*der(A[i]) = A_set[i] - A[i];
  end for;
  annotation (Documentation(info="<html>
<p>tau A_dot = A_set - A for either valve, A_set the area that
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62) gives. Source: the plunger or spool moves
against the damping of the fluid, tau = damping by stiffness of its spring
(<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Merritt 1967</a>, chapter 5), once the magnet has overcome
the preload that holds it on its seat.
<a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveLag\">ValveLag</a> lets the current lag, which also has
to climb to the threshold of (62) before anything opens, 0.4 of the way to 0.35 A, and to fall below it before all is
shut. Typical 5 to 100 ms. Both valves are shut before the start.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveLag\">ValveLag</a>, but the flow
begins at the moment of the command, and after the end of the command it dies away with a tail.</p>
</html>"));
end OpeningLag;
