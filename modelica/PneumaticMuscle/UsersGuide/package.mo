within PneumaticMuscle;
package UsersGuide "How the library is meant to be read and extended"
  extends Icons.Information;
  annotation (Documentation(info="<html>
<p>Overview, conventions, how to add an effect, references, release notes.</p>
</html>"));
end UsersGuide;
