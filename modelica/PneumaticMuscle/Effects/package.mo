within PneumaticMuscle;
package Effects "Physical effects that the base models leave out: the shelf from which a diagnosis picks"
  annotation (Documentation(info="<html>
<p>Each says in its documentation its equation, its source, typical values and its fingerprint in a measurement.
<code>UsersGuide.HowToAddAnEffect</code> says how one is made.</p>
</html>"));
end Effects;
