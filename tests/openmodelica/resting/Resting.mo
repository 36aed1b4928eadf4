within ;
package Resting "Benches that begin at rest under open valves"
  model Tank "A tank between two open valves"
    extends PneumaticMuscle.Benches.TankFilling(u_in(start=0.3), u_out(start=0.25),
      ambient(dynamics=PneumaticMuscle.Types.Dynamics.SteadyStateInitial));
  end Tank;

  model Pair "Two muscles against each other"
    extends PneumaticMuscle.Benches.Antagonistic(
      ambient(dynamics=PneumaticMuscle.Types.Dynamics.SteadyStateInitial));
  end Pair;

  model Lift "A load that hangs still, sought from a contraction of 60 mm and 280 kPa"
    extends PneumaticMuscle.Benches.Isotonic(u_in(start=0.3), u_out(start=0.2), load(s_start=0.06),
      muscle(gas(p(start=280e3))),
      ambient(dynamics=PneumaticMuscle.Types.Dynamics.SteadyStateInitial));
  end Lift;

  model Lags "The same with a gas that keeps its energy, a wall that stores heat, slow valves and instruments, and a creep"
    extends Lift(valve(redeclare model Drive = PneumaticMuscle.Effects.ValveDynamics.ValveLag),
      muscle(redeclare model Gas = PneumaticMuscle.Effects.GasEnergy.EnergyGas,
        redeclare model Wall = PneumaticMuscle.Effects.WallHeat.StorageWall),
      redeclare model PressureChannel = PneumaticMuscle.Effects.PressureSensorLag.PressureLag,
      redeclare model Thermometer = PneumaticMuscle.Effects.ThermocoupleLag.ThermocoupleSheath);
    PneumaticMuscle.Effects.Creep.PronyCreep creep(
      L0=muscle.L0, D0=muscle.D0, turns=muscle.turns, t_wall=muscle.t_wall);
  equation
    connect(creep.flange_a, muscle.flange_a);
    connect(creep.flange_b, muscle.flange_b);
    connect(creep.port, muscle.port);
  end Lags;

  model Mixed "The gas begins as it is said to, the load hangs still beside it"
    extends Lift(muscle(gas(dynamics=PneumaticMuscle.Types.Dynamics.FixedInitial)));
  end Mixed;

  model Followed "Gas and load begin at rest, an instrument and a creep where these are"
    extends PneumaticMuscle.Benches.Isotonic(u_in(start=0.3), u_out(start=0.2),
      load(s_start=0.06, dynamics=PneumaticMuscle.Types.Dynamics.SteadyStateInitial),
      muscle(gas(p(start=280e3), dynamics=PneumaticMuscle.Types.Dynamics.SteadyStateInitial)),
      redeclare model PressureChannel = PneumaticMuscle.Effects.PressureSensorLag.PressureLag);
    PneumaticMuscle.Effects.Creep.PronyCreep creep(
      L0=muscle.L0, D0=muscle.D0, turns=muscle.turns, t_wall=muscle.t_wall);
  equation
    connect(creep.flange_a, muscle.flange_a);
    connect(creep.flange_b, muscle.flange_b);
    connect(creep.port, muscle.port);
  end Followed;
end Resting;
