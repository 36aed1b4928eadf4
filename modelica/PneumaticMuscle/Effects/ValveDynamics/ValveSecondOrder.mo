within PneumaticMuscle.Effects.ValveDynamics;
model ValveSecondOrder "The valves follow their currents as a damped oscillator"
  extends Interfaces.ValveDrive(y(each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial));
  extends FamilyMember(final absent="omega=2e3");
  parameter Real omega(unit="rad/s", min=2, max=2e3, nominal=50) = 40 "Undamped angular frequency"
    annotation (Dialog(group="Effect"));
  parameter Real zeta(unit="1", min=0.3, max=2, nominal=1) = 0.8 "Damping ratio" annotation (Dialog(group="Effect"));
  Real w[2](each unit="A/s", each start=0, each fixed=dynamics == Types.Dynamics.FixedInitial, each nominal=1)
    "Rates of the currents that are felt";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(y) = zeros(2);
    der(w) = zeros(2);
  end if;
equation
  for i in 1:2 loop
    der(y[i]) = w[i];
    der(w[i]) = omega^2*(u[i] - y[i]) - 2*zeta*omega*w[i];
  end for;
  annotation (Documentation(info="<html>
<p>y_ddot + 2 zeta omega y_dot + omega^2 y = omega^2 u for either valve. Source: the mass of plunger and spring
behind the magnet, as data sheets of servo valves state it; typical 30 to 600 rad/s, 0.5 to 1. Both valves are
shut before the start.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.ValveDynamics.ValveLag\">ValveLag</a>, with a soft
beginning, and an overshoot of the flow where zeta is small.</p>
</html>"));
end ValveSecondOrder;
