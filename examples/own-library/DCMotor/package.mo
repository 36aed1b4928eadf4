package DCMotor "Direct-current motors with a load, and what simple models of them leave out"
  annotation (version="1.0.0", Documentation(info="<html>
<p>A small library of another field than pneumatics: an example of a library of one's own. SI units throughout.</p>
<p>Source of the base model: A. E. Fitzgerald, C. Kingsley, S. D. Umans, <i>Electric Machinery</i>, 6th ed., chapter 7.</p>
</html>"));
end DCMotor;
