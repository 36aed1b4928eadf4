within PneumaticMuscle;
package Icons "What the classes look like in a graphical editor"
  extends Icons.Package;
  annotation (Documentation(info="<html>
<p>Partial classes without equations; a class shows the icon that it extends. The colour of a frame is the balance:
force, mass, energy, or what an instrument reads. A law has a white frame, an effect a tinted one with the picture of
its family.</p>
</html>"));
end Icons;
