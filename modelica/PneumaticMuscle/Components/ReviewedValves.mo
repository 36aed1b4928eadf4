within PneumaticMuscle.Components;
model ReviewedValves "Inlet and exhaust valve with a place for the law of flow"
  extends Icons.Valve;
  Interfaces.GasPort supply "Supply side of the inlet valve"
    annotation (Placement(transformation(extent={{-110,50},{-90,70}})));
  Interfaces.GasPort port "Muscle or vessel"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Interfaces.GasPort exhaust "Outlet of the exhaust valve"
    annotation (Placement(transformation(extent={{-110,-70},{-90,-50}})));
  input Types.Current u_in "Current of the inlet valve";
  input Types.Current u_out "Current of the exhaust valve";
  parameter Real C_A(unit="1", min=0.1, max=3) = 0.699 "Calibration of the effective area, both valves"
    annotation (Dialog(group="Flow"));
  parameter Types.Dynamics dynamics = ambient.dynamics "How it begins: fixed, at rest, or as nothing else says"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  outer Ambient ambient "Surroundings";
  replaceable model Flow = Laws.Flows.Isentropic constrainedby Laws.Flows.Flow "Law of the flow"
    annotation (choicesAllMatching=true);
  replaceable model Area = Laws.Valves.LinearArea constrainedby Interfaces.ValveArea "Law of the effective areas"
    annotation (choicesAllMatching=true);
  replaceable model Opening = Laws.Valves.ImmediateOpening constrainedby Interfaces.ValveOpening
    "Dynamics of the openings" annotation (choicesAllMatching=true);
  replaceable model Feed = Laws.Lines.DirectFeed constrainedby Interfaces.Feed "What lies before the inlet valve"
    annotation (choicesAllMatching=true);
  Feed feed "What lies before the inlet valve";
  Area area(u={u_in, u_out}, p_a={feed.port_b.p, port.p}, p_b={port.p, exhaust.p}, C_A=C_A) "From current to effective area";
  Opening opening(A_set=area.A, dynamics=dynamics) "From that to the area that the gas finds";
  Flow inlet(A=opening.A[1]) "Inlet valve";
  Flow outlet(A=opening.A[2]) "Exhaust valve";
equation
  connect(supply, feed.port_a);
  connect(feed.port_b, inlet.port_a);
  connect(inlet.port_b, port);
  connect(port, outlet.port_a);
  connect(outlet.port_b, exhaust);
  annotation (Documentation(info="<html>
<p>As <code>ValvePair</code>, DP (62); the laws of flow are in <code>Laws.Flows</code>.</p>
</html>"));
end ReviewedValves;
