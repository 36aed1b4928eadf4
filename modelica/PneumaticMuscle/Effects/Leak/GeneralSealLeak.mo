within PneumaticMuscle.Effects.Leak;
model GeneralSealLeak
  "Gas escapes by any smooth law of gauge pressure and temperature, of now and before, or above a threshold"
  extends ThresholdLeak(final general=true, n_T=-2);
  parameter Real bend_T(unit="1", min=-60, max=60, nominal=10) = 0
    "Coefficient of the square of the temperature's logarithm"
    annotation (Dialog(group="Effect"));
  parameter Real n_p(unit="1", min=-2, max=3, nominal=0.5) = 0.2
    "Exponent of the decrease of the conductance with the delayed absolute pressure of the seal"
    annotation (Dialog(group="Effect"));
  parameter Real back(unit="1", min=0, max=1, nominal=0.3) = 0
    "Fraction of the delayed pressure that drives gas back"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=0.01, max=60, nominal=1) = 0.5 "Time constant of the seal"
    annotation (Dialog(group="Effect"));
  Types.AbsolutePressure p_seal "Pressure that the seal has followed";
initial equation
  if dynamics == Types.Dynamics.FixedInitial then
    p_seal = ambient.p;
  elseif dynamics == Types.Dynamics.SteadyStateInitial then
    der(p_seal) = 0;
  end if;
equation
  tau*der(p_seal) = port.p - p_seal;
  driving = q - back*(p_seal - ambient.p)/p_reference;
  further = warm*(n_T + bend_T*warm) - n_p*log(max(p_seal, 1.0)/ambient.p);
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G 100 kPa r |r|^(a + b ln|r|) exp(g (q - 1) + bend_T w^2) (T/T_atm)^n_T (p_seal/p_atm)^(-n_p), w =
ln(T/T_atm), tau p_seal_dot = p - p_seal: <a
href=\"modelica://PneumaticMuscle.Effects.Leak.ThresholdLeak\">ThresholdLeak</a> with d = q - back (p_seal -
p_atm)/100 kPa, and with what <a href=\"modelica://PneumaticMuscle.Effects.Leak.SealLeak\">SealLeak</a> does, and one
more term of the temperature. Gas that dissolves in a wall and diffuses through comes back when the pressure falls:
back = 1/2 where the middle of the wall stands for all of it (<a
href=\"modelica://PneumaticMuscle.UsersGuide.References\">Barrer 1939</a>). It needs no muscle: the family's general
member on vessels. Source: first terms of the expansion of the logarithm of the conductance. Typical as there, bend_T
-30 to 30.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.SealLeak\">SealLeak</a>, by another law of pressure
and temperature.</p>
</html>"));
end GeneralSealLeak;
