within PneumaticMuscle.Laws.Forces;
model NotChosen "Refuses: a law of force must be chosen"
  extends Interfaces.Cylinder;
equation
  assert(false, "no law of force is chosen: redeclare model Force, for example "
    + "redeclare model Force = PneumaticMuscle.Laws.Forces.Gaylord; the package Laws.Forces lists them");
  F = 0;
  annotation (Documentation(info="<html>
<p>The default of
<a href=\"modelica://PneumaticMuscle.Muscles.Components.ReviewedMuscle\">Components.ReviewedMuscle</a>. A model that
still has it cannot be compiled.</p>
</html>"));
end NotChosen;
