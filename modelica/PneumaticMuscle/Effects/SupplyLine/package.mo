within PneumaticMuscle.Effects;
package SupplyLine "A line between the valves and the muscle or vessel"
  extends Icons.SupplyLine;
  annotation (Documentation(info="<html>
<p>The family <code>supply_line</code>: a resistance, with or without a volume, between the valves and the muscle or
vessel.</p>
<p>Fingerprint: filling and venting are slower when the valve is wide open and right when it is nearly shut; the holds
are right. A line with a volume goes on flowing a little after the valves have shut.</p>
</html>"));
end SupplyLine;
