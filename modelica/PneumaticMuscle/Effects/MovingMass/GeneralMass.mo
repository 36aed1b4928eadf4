within PneumaticMuscle.Effects.MovingMass;
model GeneralMass "Moving parts of any inertia and weight, and a part that is dragged along with slip, both ways or one"
  extends FamilyMember(final general=true, final absent="m=0, m_weight=0, m_slip=0");
  parameter Types.Dynamics dynamics = ambient.dynamics "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  parameter Types.Mass m(min=0, max=100, nominal=1) = 1 "Inertia at full length, referred to the load end"
    annotation (Dialog(group="Effect"));
  parameter Real a(unit="1", min=-1, max=2, nominal=0.3) = 0 "Relative growth of the inertia per reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1", min=-0.4, max=0.6, nominal=0.1) = 0 "Quadratic coefficient of the growth"
    annotation (Dialog(group="Effect"));
  parameter Types.Mass m_weight(min=0, max=100, nominal=0.5) = 0.3 "Hanging mass at full length"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="1", min=-1, max=1.5, nominal=0.3) = 0 "Relative growth of the weight per reference contraction"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="1", min=-0.3, max=0.3, nominal=0.1) = 0 "Quadratic coefficient of the growth"
    annotation (Dialog(group="Effect"));
  parameter Types.Mass m_slip(min=0, max=100, nominal=1) = 0.3 "Inertia of the dragged part"
    annotation (Dialog(group="Effect"));
  parameter Types.Time tau(min=2e-3, max=10, nominal=0.1) = 0.1 "Time constant of acceleration of the dragged part"
    annotation (Dialog(group="Effect"));
  parameter Real one_way(unit="1", min=0, max=1, nominal=0.3) = 0.1
    "Fraction of the slip force lost in braking (1: cord or freewheel)"
    annotation (Dialog(group="Effect"));
  parameter Types.Time coast(min=0.05, max=1e3, nominal=10) = 100 "Time constant of free deceleration"
    annotation (Dialog(group="Effect"));
  parameter Types.Acceleration a_slide(min=0.05, max=1e4, nominal=10) = 1e3
    "Acceleration at which the coupling slides"
    annotation (Dialog(group="Effect"));
  Types.Velocity w(start=0, fixed=dynamics == Types.Dynamics.FixedInitial) "Speed of what is dragged along";
protected
  constant Real e_reference(unit="1") = 0.125 "Reference contraction, by the length";
  constant Real e_smooth(unit="1") = 0.01 "Contraction over which the growth begins";
  constant Types.Velocity v_smooth = 1e-3 "Slip over which it changes sides";
  Types.Velocity slip = (v - w)*(1 - 0.5*one_way*(1 - (v - w)/sqrt((v - w)^2 + v_smooth^2)))
    "Slip, what counts of it";
  Types.Acceleration taken = a_slide*tanh(slip/(a_slide*tau)) "Acceleration of what is dragged along";
  Types.Length x_size = sqrt(x^2 + (e_smooth*L0)^2) "Rounded size of the contraction";
  Real s(unit="1") = 0.5*(x + x_size)/(e_reference*L0) "Contraction by the reference, zero beyond full length";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(w) = 0;
  end if;
equation
  der(w) = taken - w/coast;
  f = m*exp(s*(a + b*s))*(der(v) + 0.5*(a + 2*b*s)*s/x_size*v^2) + m_weight*Constants.g*exp(s*(c + d*s))
    + m_slip*taken;
  annotation (defaultComponentName="movingMass", Documentation(info="<html>
<p>f = m(x) v_dot + m'(x) v^2/2 + w(x) + m_slip a, w_dot = a - w/coast, a = a_slide tanh(e/(a_slide tau)), e = v - w
where that is positive and (1 - one_way) (v - w) where it is not, m(x) = m exp(a s + b s^2), w(x) = m_weight g exp(c s
+ d s^2), s = 8 x/L0. Source: Lagrange's equation as in <a
href=\"modelica://PneumaticMuscle.Effects.MovingMass.FlexibleMass\">FlexibleMass</a>, see there, with one more term of
the inertia; a body that a fluid, a belt or a cord drags along with a slip in proportion to the force is a Maxwell
element whose spring is replaced by its inertia; a cord only pulls, and a freewheel lets it run on; a torque limiter
slides at an acceleration (<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Budynas and Nisbett 2011</a>).
Typical as there, m_slip 0.1 to 20 kg, tau 0.02 to 1 s, one_way 0, or 1 for a cord, coast 0.3 s and more.</p>
<p>Fingerprint: as <a href=\"modelica://PneumaticMuscle.Effects.MovingMass.FlexibleMass\">FlexibleMass</a>; slow
motion feels all of the inertia, a jerk only a part.</p>
</html>"));
end GeneralMass;
