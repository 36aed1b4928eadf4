within PneumaticMuscle.Interfaces;
partial model RigPart "A part that a rig can be put together from"
  extends Icons.Named;
  constant String shows = "" "Signals that are usually read where the part is used, such as p, T";
  annotation (Documentation(info="<html>
<p>Its inputs become those of the rig. A parameter that has no value here takes that of the same name from
another part of the rig: a load its start from the muscle, a muscle its load from what it pulls.</p>
</html>"));
end RigPart;
