within PneumaticMuscle.Effects;
package MovingMass "Mass that moves with the load and was not counted"
  extends Icons.MovingMass;
  annotation (Documentation(info="<html>
<p>The family <code>moving_mass</code>: inertia, weight or both, of what moves with the load end.</p>
<p>Fingerprint: jumps are slower; the contraction rings after a step, more slowly the larger the mass is. Where the mass
hangs, the contraction falls short by the same force in every hold too.</p>
</html>"));
end MovingMass;
