within PneumaticMuscle.Mechanics;
model Spring "A spring that the muscle stretches"
  extends Interfaces.Mechanics(shows="x, F", final F_start=F_0);
  extends Components.SlidingMass(m=0.5, final s_start=x_start);
  extends Icons.Stop;
  parameter Types.TranslationalStiffness k(min=1, max=1e6) = 2000 "Stiffness" annotation (Dialog(group="Mechanics"));
  parameter Types.Force F_0(min=0, max=1e4) = 5 "Preload, at the start" annotation (Dialog(group="Load"));
  parameter Types.TranslationalDamping d(min=0, max=1e4) = 5 "Damping of the guide"
    annotation (Dialog(group="Mechanics"));
equation
  f_back = F_0 + k*(s - x_start) + d*v;
  annotation (Documentation(info="<html>
<p>m x_ddot = F - F_0 - k (x - x_start) - d x_dot: Hooke's spring on a level slide, stretched by F_0 at the start.
Values are for illustration.</p>
</html>"));
end Spring;
