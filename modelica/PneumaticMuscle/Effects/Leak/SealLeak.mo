within PneumaticMuscle.Effects.Leak;
model SealLeak "Gas escapes past a soft seal, which shrinks in the cold and is pressed into its gap with time"
  extends FamilyMember(final absent="G=0");
  parameter Real G(unit="kg/(s.Pa)", min=0, max=1e-9, nominal=1e-11) = 1e-11
    "Conductance at ambient temperature, before the seal has moved"
    annotation (Dialog(group="Effect"));
  parameter Real n_T(unit="1", min=-40, max=10, nominal=3) = -5 "Exponent of the temperature of the gas"
    annotation (Dialog(group="Effect"));
  parameter Real n_p(unit="1", min=-2, max=3, nominal=0.5) = 0.2
    "Exponent of the decrease of the conductance with the delayed absolute pressure of the seal"
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
  port.m_flow = G*(port.p - ambient.p)*exp(n_T*log(max(port.T, 1.0)/ambient.T) - n_p*log(max(p_seal, 1.0)/ambient.p));
  port.H_flow = port.m_flow*Constants.cp*Functions.upstreamTemperature(port.p, ambient.p, port.T, ambient.T);
  annotation (defaultComponentName="leak", Documentation(info="<html>
<p>m_flow = G p_gauge (T/T_atm)^n_T (p_seal/p_atm)^(-n_p), tau p_seal_dot = p - p_seal. Source: rubber shrinks about
ten times as much as the metal about it, and a gap's flow goes with the cube of its width; a soft seal is pressed into
its gap and creeps there (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Gent 2012</a>); first terms of
the expansion of the logarithm of the conductance. Negative n_p: pressure opens the gap. Typical G as <a
href=\"modelica://PneumaticMuscle.Effects.Leak.LaminarLeak\">LaminarLeak</a>, n_T -40 to -2, n_p 0 to 2, tau 0.3 to 10
s.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.Leak.LaminarLeak\">LaminarLeak</a>, more while the gas
is cold from venting, less the longer the pressure stands.</p>
</html>"));
end SealLeak;
