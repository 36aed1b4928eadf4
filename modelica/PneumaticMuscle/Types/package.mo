within PneumaticMuscle;
package Types "Physical quantities with their SI units"
  extends Icons.Package;
  type AbsolutePressure = Real(final quantity="Pressure", final unit="Pa", displayUnit="kPa", nominal=1e5, min=0)
    "Absolute pressure";
  type GaugePressure = Real(final quantity="Pressure", final unit="Pa", displayUnit="kPa", nominal=1e5)
    "Pressure above the ambient, as instruments read it";
  type Temperature = Real(final quantity="ThermodynamicTemperature", final unit="K", displayUnit="degC", nominal=300,
    min=1) "Absolute temperature";
  type Length = Real(final quantity="Length", final unit="m", displayUnit="mm", nominal=0.1) "Length, position";
  type Velocity = Real(final quantity="Velocity", final unit="m/s", nominal=0.1) "Speed";
  type Acceleration = Real(final quantity="Acceleration", final unit="m/s2") "Acceleration";
  type Area = Real(final quantity="Area", final unit="m2") "Area";
  type Volume = Real(final quantity="Volume", final unit="m3", nominal=1e-4) "Volume";
  type VolumeFlowRate = Real(final quantity="VolumeFlowRate", final unit="m3/s", nominal=1e-4) "Rate of a volume";
  type Mass = Real(final quantity="Mass", final unit="kg") "Mass";
  type MassFlowRate = Real(final quantity="MassFlowRate", final unit="kg/s", nominal=1e-4) "Mass flow rate";
  type Force = Real(final quantity="Force", final unit="N", nominal=10) "Force";
  type Power = Real(final quantity="Power", final unit="W") "Power, heat flow rate, enthalpy flow rate";
  type Time = Real(final quantity="Time", final unit="s") "Time";
  type RecordDelay = Real(final quantity="RecordDelay", final unit="s", nominal=0.02)
    "By how much the clock of a record of readings is ahead of that of the inputs";
  type Voltage = Real(final quantity="ElectricPotential", final unit="V") "Electric voltage";
  type Current = Real(final quantity="ElectricCurrent", final unit="A") "Electric current";
  type TranslationalStiffness = Real(final quantity="Stiffness", final unit="N/m") "Stiffness";
  type TranslationalDamping = Real(final quantity="Damping", final unit="N.s/m") "Damping";
  type HeatCapacity = Real(final quantity="HeatCapacity", final unit="J/K", nominal=1) "Heat capacity";
  type ThermalConductance = Real(final quantity="ThermalConductance", final unit="W/K") "Thermal conductance";
  type Pressure = Real(final quantity="Pressure", final unit="Pa") "Stress, elastic modulus";
  type SpecificHeatCapacity = Real(final quantity="SpecificHeatCapacity", final unit="J/(kg.K)")
    "Specific heat capacity";
  type ThermalConductivity = Real(final quantity="ThermalConductivity", final unit="W/(m.K)") "Thermal conductivity";
  type CoefficientOfHeatTransfer = Real(final quantity="CoefficientOfHeatTransfer", final unit="W/(m2.K)")
    "Heat transfer coefficient";
  type Dynamics = enumeration(
    DynamicFreeInitial "Guess: from the start values",
    FixedInitial "Fixed: with the start values",
    SteadyStateInitial "Steady: at rest under the first inputs, sought from the start values")
    "How what is stored begins; the names are those of Modelica.Fluid.Types.Dynamics";
  annotation (Documentation(info="<html>
<p>Units are final; nominal values are of the size met in a muscle of
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a>.</p>
</html>"));
end Types;
