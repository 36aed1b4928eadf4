within PneumaticMuscle.Effects.ValveDynamics;
model ValveLag "The valves follow their currents with a first-order lag"
  extends Interfaces.ValveDrive(y(each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="tau=1e-6");
  parameter Types.Time tau(min=1e-6, max=2, nominal=0.05) = 0.05 "Time constant" annotation (Dialog(group="Effect"));
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(y) = zeros(2);
  end if;
equation
  for i in 1:2 loop
    tau*der(y[i]) = u[i] - y[i];
  end for;
  annotation (Documentation(info="<html>
<p>tau y_dot = u - y for either valve. Source: the first-order lag that data sheets of proportional valves give.
Typical 5 to 100 ms. Both valves are shut before the start.</p>
<p>Fingerprint: pressure and contraction are late at every switching of a valve; the holds are right.</p>
</html>"));
end ValveLag;
