within PneumaticMuscle;
package Effects "Physical effects that the base models leave out: the shelf from which a diagnosis picks"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>One package for each family: effects that leave the same kind of mark on a measurement, told in the package's
documentation. A member extends the package's <code>FamilyMember</code>, which says the family and the balance.</p>
<p>Each says in its documentation its equation, its source, typical values and its fingerprint in a measurement.
<a href=\"modelica://PneumaticMuscle.UsersGuide.HowToAddAnEffect\">UsersGuide.HowToAddAnEffect</a> says how one is
made.</p>
</html>"));
end Effects;
