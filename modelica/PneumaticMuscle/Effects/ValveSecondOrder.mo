within PneumaticMuscle.Effects;
model ValveSecondOrder "The valves follow their currents as a mass on a damped spring does"
  extends Interfaces.ValveDrive;
  extends Interfaces.Effect(final family="valve_dynamics", final balance="mass");
  parameter Real omega(unit="rad/s", min=2, max=1000, nominal=50) = 50 "Natural frequency";
  parameter Real zeta(unit="1", min=0.2, max=4, nominal=1) = 0.8 "Damping ratio";
protected
  Real rate[2](each unit="A/s", each start=0, each fixed=true, each nominal=10) "Rate of change of the openings' currents";
equation
  for i in 1:2 loop
    der(y[i]) = rate[i];
    der(rate[i]) = omega^2*(u[i] - y[i]) - 2*zeta*omega*rate[i];
  end for;
  annotation (Documentation(info="<html>
<p>y_ddot + 2 zeta omega y_dot + omega^2 y = omega^2 u for either valve: the armature on its spring that DP section 4.4
describes and leaves out. Typical natural frequencies are 20 to 500 rad/s.</p>
<p>Fingerprint: pressure and contraction start late at every switching of a valve, more softly than with ValveLag; the
holds are right.</p>
</html>"));
end ValveSecondOrder;
