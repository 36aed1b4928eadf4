within WindTunnel.Benches;
model TwoFans "Both fans with their tachometers, and the barometer behind the intake"
  input Real L_in(unit="1", start=0.01) "Load of the intake fan";
  input Real L_out(unit="1", start=0.01) "Load of the exhaust fan";
  input Real hatch(unit="1", start=0) "Opening of the hatch, 0 to 1";
  output Real w_in(unit="rad/s") "Speed of the intake fan";
  output Real w_out(unit="rad/s") "Speed of the exhaust fan";
  output Real i_in(unit="A") "Current of the intake fan";
  output Real i_out(unit="A") "Current of the exhaust fan";
  output Real p(unit="Pa") "Pressure in the chamber, above that of the surroundings";
  inner Components.Air air(hatch=hatch) "Air of the tunnel";
  Components.Fans fans(u_in=L_in, u_out=L_out) "Fans";
  Components.Rotor intake "Rotor of the intake fan";
  Components.Rotor exhaust "Rotor of the exhaust fan";
  Components.Chamber chamber(w_in=intake.shaft.w, w_out=exhaust.shaft.w) "Pressure";
  replaceable model Tachometer = Components.DirectTachometer constrainedby Interfaces.Tachometer "Reading of the speeds"
    annotation (choicesAllMatching=true);
  Tachometer tachometer(w_in=intake.shaft.w, w_out=exhaust.shaft.w) "Tachometers";
equation
  connect(fans.intake, intake.shaft);
  connect(fans.exhaust, exhaust.shaft);
  w_in = tachometer.y_in;
  w_out = tachometer.y_out;
  i_in = fans.i_in;
  i_out = fans.i_out;
  p = chamber.p;
  annotation (experiment(StopTime=45, Interval=0.15));
end TwoFans;
