within ;
package Started "Benches and effects that begin elsewhere, by start values as Modelica has them"
  model Muscle "A muscle under pressure, its load on the way up"
    extends PneumaticMuscle.Benches.Isotonic(
      u_in(start=0.3),
      muscle(gas(p(start=219325, fixed=true))),
      load(s(start=0.031, fixed=true), v(start=0.02, fixed=true)));
  end Muscle;

  model Tank "Half full and warm, the valve open"
    extends PneumaticMuscle.Benches.TankFilling(u_in(start=0.3), tank(p_start=180000));
  end Tank;

  model OpenValve "The opening of the valve is where the current has it"
    extends Muscle(valve(redeclare model Drive = PneumaticMuscle.Effects.ValveDynamics.ValveLag));
  end OpenValve;

  model Wall "The wall is warm, the bladder has relaxed"
    extends Muscle(muscle(redeclare model Wall = PneumaticMuscle.Effects.WallHeat.StorageWall));
    PneumaticMuscle.Effects.Creep.PronyCreep creep(
      L0=muscle.L0, D0=muscle.D0, turns=muscle.turns, t_wall=muscle.t_wall);
  equation
    connect(creep.flange_a, muscle.flange_a);
    connect(creep.flange_b, muscle.flange_b);
    connect(creep.port, muscle.port);
  end Wall;
end Started;
