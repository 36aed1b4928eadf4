within PneumaticMuscle.Effects.MovingMass;
model BalancedMass "Moving parts whose weight is balanced: inertia alone"
  extends FamilyMember(final absent="m=0");
  parameter Types.Mass m(min=0, max=200, nominal=5) = 5 "Mass, referred to the load end"
    annotation (Dialog(group="Effect"));
equation
  f = m*der(v);
  annotation (defaultComponentName="movingMass", Documentation(info="<html>
<p>f = m v_dot. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (18) for parts that do not
lift, such as a pulley, a lever with a counterweight or a slide; the inertia of a wheel is J/r^2. Typical 0.5 to 20
kg.</p>
<p>Fingerprint: only fast changes are wrong: the start is later, and the contraction rings after a step, more
slowly the larger the mass is. Holds are right.</p>
</html>"));
end BalancedMass;
