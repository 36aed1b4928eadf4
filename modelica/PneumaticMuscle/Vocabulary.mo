within PneumaticMuscle;
record Vocabulary "Words of the field for recorded quantities, their usual units, and neutral values"
  extends Icons.Record;
  constant String kinds[:, 4] = {
    {"time", "s", "", "=t =time =zeit =temps =sec =sek time zeit temps elapsed =micros =millis"},
    {"pressure", "Pa", "counted", "=p =pm =pk =ps =pset =psoll =psp =pref =pcmd =psup =psupply =psource =pamb =patm "
    + "=baro =pist =pmus =pmuscle =pdes =pact barometer barometr pressure druck pression press"},
    {"temperature", "K", "transmitted", "=t =tamb =temp temperature temperatur thermo"},
    {"current", "A", "", "=i =u =strom =courant current strom courant intensite"},
    {"command", "1", "share", "valve ventil vanne schalt switch solenoid =pwm duty command befehl commande relais "
    + "relay =cmd =u"},
    {"force", "N", "counted", "=f =fz =fx =last =load =charge force kraft effort loadcell kraftmess zugkraft =pull "
    + "=traction"},
    {"ratio", "1", "share", "=eps epsilon strain ratio dehnung stauchung verhaltnis"},
    {"contraction", "m", "counted", "=x =s =z =y =dx =dl =weg =hub =pos =disp contraction kontraktion displacement "
    + "verschiebung verkurzung verkuerzung raccourcissement deplacement stroke position weggeber wegsensor laser "
    + "course travel shortening seilzug drawwire"},
    {"length", "m", "counted", "=l =len =lange length laenge lange longueur"},
    {"mass", "kg", "unused", "=mass =masse =gewicht weight gewicht poids"},
    {"angle", "rad", "", "angle winkel =phi =theta"},
    {"voltage", "V", "unused", "voltage spannung"},
    {"count", "1", "unused", "cycle zyklus takt index sample trial versuch number nummer numero =no =nr =n =id "
    + "=point =punkt =lauf"},
    {"direction", "1", "unused", "=dir direction richtung =branch =zweig =ast =sens =phase =hysteresis hysterese "
    + "inflat deflat loading"}}
    "What can be recorded: its name, SI unit, traits, and words; one with = stands alone, others also within a word. "
    + "Traits: counted (by a converter, a camera or a bridge), transmitted (by a current), share (needs no unit), "
    + "unused (no signal)";
  constant String roles[:, 3] = {
    {"supply", "pressure", "supply source versorgung vordruck netzdruck alimentation reservoir tank upstream kessel "
    + "=sup =src =ps =psup"},
    {"set", "pressure", "=set =sp =soll =ref =cmd =pset =psoll =psp =pref =pcmd =pdes setpoint soll consigne target "
    + "desired reference wanted demand told command befehl"},
    {"inlet", "command", "=in =inl =ein =zu inlet intake einlass zuluft admission beluft belueft fill fullen gonflage "
    + "remplissage"},
    {"exhaust", "command", "=out =ex =exh =aus =ab =vent exhaust outlet auslass abluft entluft entlueft echappement "
    + "purge vidange"},
    {"ambient", "", "ambient room raum umgebung raumtemp raumluft ambiant atmos outside labor =amb =tamb =pamb =patm "
    + "=atm =umg =baro barometer barometr"}}
    "Roles that distinguish a quantity from others of its kind, the kind that its word means alone, and words";
  constant String units[:, 2] = {
    {"pressure", "1.2 MPa, 15 bar, 2e3 kPa, Pa"},
    {"ambient pressure", "1.2 bar, 16 psi, 120 kPa, 1.2e3 hPa, Pa"},
    {"contraction", "0.7 m, 2e3 mm, um"},
    {"length", "0.7 m, 3e3 mm, um"},
    {"ratio", "1, %"},
    {"command", "1, 120 %"},
    {"force", "N"},
    {"mass", "kg"},
    {"temperature", "200 degC, K"},
    {"current", "2 A, mA"}}
    "Unit of numbers without one, by their largest magnitude in this unit";
  constant String spellings[:, 2] = {
    {"bar", "bar"}, {"kPa", "kpa"}, {"hPa", "hpa"}, {"Pa", "pa"}, {"psi", "psi"}, {"MPa", "mpa"}, {"mbar", "mbar"},
    {"torr", "torr"}, {"kgf/cm2", "kgf/cm2, kg/cm2, kg/cm^2, kp/cm2"},
    {"lbf/in2", "lb/in2, lbs/in2, lb/in^2, lbs/in^2"}, {"ms", "msec"},
    {"s", "sec, sek, sek., secs, seconds, sekunden, secondes"}, {"N", "newton, n"}, {"kN", "kn"}, {"kg", "kg"},
    {"degC", "celsius, c, degc, grad c, deg c"}, {"degF", "fahrenheit, f, degf, grad f, deg f"}, {"K", "kelvin"},
    {"A", "ampere, amp, a"}, {"mA", "ma"}, {"V", "volt, volts, v"}, {"mm", "mm, millimeter"}, {"cm", "cm"},
    {"deg", "grad"}, {"inch", "inch, in., zoll, \", ''"}, {"%", "prozent, percent, pct"}}
    "A unit, and its spellings in small letters";
  constant String counts[:] = {"count", "counts", "bit", "bits", "digit", "digits", "lsb", "px", "pix", "pixel",
    "pixels", "mv/v"} "Units of a converter, a camera or a bridge, whose size only the laboratory knows";
  constant String sure[:, 2] = {
    {"pressure", "*druck pressure pression"},
    {"force", "*kraft force loadcell"},
    {"temperature", "*temperatur temperature"}}
    "Words that determine a kind whatever the unit; * is any beginning";
  constant String directions[:, 2] = {
    {"down", "deflat =down =d =ab abwarts =fall falling decreas unload entlast entluft release =vent venting exhaust "
    + "extend extension =ruck ruckhub descen degonfl =back backward return =out"},
    {"up", "inflat =up =u =auf aufwarts =rise rising increas load belast beluft press fill contract =hin hinhub mont "
    + "gonfl =forward =in"}}
    "Words for the way in which a muscle went; those of the first row come before those of the second";
  constant String data_sheets[:, 5] = {
    {"C_A", "m2", "A", "1.80e-6 m2/A", "0.145 A"},
    {"C_A", "m2", "1", "1e-5 m2", ""}}
    "A parameter, unit of the size in data sheets, unit of the input, what an input of one opens where the parameter is "
    + "one, and the input at which it begins to open; without that, what the largest input opens";
  constant String nominal[:, 3] = {{"m3/s", "m2", "9.97e-4 s/m"}}
    "Size that data sheets state instead of it: a flow at 20 degC and 1 bar, from 6 to 5 bar gauge, without friction";
  constant String calibrated[:] = {"calibration", "effective area", "discharge coefficient",
    "pressure lost per mass flow", "time constant", "polytropic", "film coefficient"}
    "Parameters that are not measured, by words of their descriptions: a fit determines them";
  constant String uncertain[:] = {"coefficient of friction", "damping", "friction"}
    "Further parameters that may be free";
  constant String chosen[:] = {"filter"} "Parameters that are chosen and neither stated nor fitted";
  constant String walls[:] = {"loss of the wall", "wall bends open", "threshold pressure"}
    "Parameters of what the wall of a muscle takes of its pull, where no rule reaches";
  constant String fibres[:] = {"fibres lie", "fibres and axis"} "Parameters of where the fibres of a wall lie";
  constant String measures[:, 2] = {{"L0", "along"}, {"D0", "around"}, {"turns", "around"}, {"b", "along"},
    {"alpha_0", "along"}}
    "Measures of a sleeve, its length first: three determine it, one of them around it";
  constant String neutral[:, 2] = {{"mu_fb", "0"}, {"mu_d", "0"}, {"fibres", "1"}}
    "Values of an unnamed muscle: fibres without friction that cover nothing. Friction is looked for then";
  annotation (Documentation(info="<html>
<p>Data for who reads the files of a laboratory; no model has a component of this class. Words are written in small
letters without accents. A library of another field brings a record of this name of its own.</p>
</html>"));
end Vocabulary;
