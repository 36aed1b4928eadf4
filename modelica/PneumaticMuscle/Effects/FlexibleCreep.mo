within PneumaticMuscle.Effects;
model FlexibleCreep "The bladder relaxes over two and a half decades of time"
  extends Interfaces.ForceEffect(final family="creep", final absent="k_1=0, k_2=0, k_3=0");
  parameter Types.TranslationalStiffness k_1(min=0, max=2e4, nominal=300) = 150 "Stiffness that relaxes first";
  parameter Types.TranslationalStiffness k_2(min=0, max=2e4, nominal=300) = 150 "Stiffness that relaxes seven times later";
  parameter Types.TranslationalStiffness k_3(min=0, max=2e4, nominal=300) = 150 "Stiffness that relaxes once more seven times later";
  parameter Types.Time tau(min=0.1, max=20, nominal=0.5) = 0.3 "Time in which the first relaxes";
  Types.Length q[3] "Parts of the contraction that have relaxed";
initial equation
  q = {x, x, x};
equation
  tau*der(q[1]) = x - q[1];
  7*tau*der(q[2]) = x - q[2];
  49*tau*der(q[3]) = x - q[3];
  f = k_1*(x - q[1]) + k_2*(x - q[2]) + k_3*(x - q[3]);
  annotation (defaultComponentName="creep", Documentation(info="<html>
<p>Three Maxwell elements in parallel, a Prony series. Source: J. D. Ferry, <i>Viscoelastic properties of
polymers</i>; a positive series of exponentials dissipates and approaches any completely monotone relaxation. Over 0.02
to 10 s it is within 2.5 % of stretched exponentials (Kohlrausch), of power laws that begin at a finite value and of
the logarithm of time, where two elements (PronyCreep) leave up to 9 %. Typical 50 to 500 N/m, tau 0.1 to 1 s.</p>
<p>Fingerprint: as PronyCreep; no time stands out after which the creep is over.</p>
</html>"));
end FlexibleCreep;
