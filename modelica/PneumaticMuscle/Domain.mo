within PneumaticMuscle;
record Domain "Terms for reports in this field: its balances, its phases, and the variables of a missing term"
  extends Icons.Record;
  constant String balances[:] = {"force", "mass", "energy"} "Balances, in the order in which they are opened and drawn";
  constant String confused[:, 3] = {{"mass", "energy",
    "a law of the gas that keeps books of its energy explains the samples as well: unless a signal that shows "
    + "the temperature is fitted, missing mass and missing heat cannot be separated"}}
    "Where the first balance fails and a law hides the second, a law that has the second is tried too; "
    + "sentence where both explain the samples";
  constant String phases[:, 4] = {{"Pa", "filling", "holding", "venting"}}
    "Unit of the output that divides a run into phases, and names of its rise, rest and fall";
  constant String moving[:] = {"m"}
    "Units of outputs of which it matters whether they grow, rest or shrink, and how fast";
  constant String axes[:] = {"x", "T_excess", "p_gauge", "v"}
    "Variables that a missing term is drawn against, the telling ones first";
  constant String planes[:, 2] = {{"x", "p_gauge"}, {"T_excess", "p_gauge"}, {"p_rate", "p_gauge"}}
    "Pairs of variables that a missing term is drawn over; the first that a term has both of counts";
  constant String tested = "pressures, loads and speeds" "What a tested range is a range of";
  constant String ranges[:, 3] = {{"Pa", "-9e4", "2e7"}, {"A", "-20", "20"}, {"V", "-100", "100"}, {"m", "-3", "3"},
    {"K", "200", "600"}, {"N", "-5e4", "5e4"}, {"s", "0.1", "10000"}}
    "Unit, least and largest number of it that a rig usually has, gauge pressures; of s, the duration of a run";
  constant String instruments[:, 2] = {
    {"pressure_offset", "the reading of the pressure is off by an amount that follows from the pressure alone"},
    {"pressure_sensor_lag", "the reading of the pressure comes late"},
    {"position_sensor", "the reading of the position is off, or comes late"},
    {"force_sensor", "the reading of the force is off, or comes late"},
    {"temperature_sensor",
    "the reading of the temperature is off by an amount that follows from the temperature alone"},
    {"thermocouple_lag", "the reading of the temperature comes late"},
    {"saturation", "a reading ends at a limit where its signal goes on"},
    {"clock_offset", "the record of all readings is shifted in time against that of the inputs"}}
    "Families that are faults of an instrument, and the sentence on that instrument";
  annotation (Documentation(info="<html>
<p>Data for reports on a measurement; no model has a component of this class. A library without it is reported in
words that fit any field.</p>
</html>"));
end Domain;
