within PneumaticMuscle.Interfaces;
partial model Gas "The gas in a volume: how pressure and temperature follow from mass, heat and work"
  extends VesselTerminals;
  extends Icons.Gas;
  HeatPort heatPort "Heat from the wall"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  input Types.Volume V "Volume of the gas";
  parameter Real n(unit="1", min=1, max=1.4) "Polytropic exponent, for the gases that use one"
    annotation (Dialog(group="Gas"));
  parameter Types.AbsolutePressure p_start "Pressure at the start" annotation (Dialog(group="Start"));
  parameter Types.Temperature T_start "Temperature at the start" annotation (Dialog(group="Start"));
  parameter Types.AbsolutePressure p_reference "Pressure at which the polytropic law has its reference temperature"
    annotation (Dialog(group="Start"));
  parameter Types.Temperature T_reference "Reference temperature of the polytropic law"
    annotation (Dialog(group="Start"));
  parameter Types.CoefficientOfHeatTransfer h_film "Film coefficient that the owner assumes"
    annotation (Dialog(group="Heat"));
  parameter Types.Dynamics dynamics = Types.Dynamics.FixedInitial
    "Initial condition"
    annotation (Evaluate=true, Dialog(tab="Initialisation", group="Start"));
  Types.AbsolutePressure p(start=p_start, fixed=dynamics == Types.Dynamics.FixedInitial) "Absolute pressure";
  Types.Temperature T "Temperature";
  Types.CoefficientOfHeatTransfer h_wall "Film coefficient at the wall";
initial equation
  if dynamics == Types.Dynamics.SteadyStateInitial then
    der(p) = 0;
  end if;
equation
  port.p = p;
  port.T = T;
  heatPort.T = T;
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of the pressure, of the temperature and of h_wall; and, where it stores
more than the pressure tells, how that begins, by <code>dynamics</code>.</p>
</html>"));
end Gas;
