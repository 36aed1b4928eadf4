package StandardParts "Muscles among parts of the Modelica Standard Library"
  partial model Hung "A muscle behind a supply and two valves, which hangs from a ceiling"
    extends PneumaticMuscle.Interfaces.Rig;
    extends PneumaticMuscle.Benches.BaseClasses.ValveSupply;
    extends PneumaticMuscle.Benches.BaseClasses.HungMuscle;
  equation
    connect(line.port_b, muscle.port);
  end Hung;

  model SpringDamper "A muscle that pulls a mass against a spring and a damper"
    extends Hung;
    extends PneumaticMuscle.Benches.BaseClasses.CurrentSupply;
    Modelica.Mechanics.Translational.Components.Mass mass(
      m=2, s(start=0, fixed=true), v(start=0, fixed=true)) "Load";
    Modelica.Mechanics.Translational.Components.SpringDamper spring(c=4000, d=60, s_rel0=0.1)
      "Opposes the contraction";
    Modelica.Mechanics.Translational.Components.Fixed floor(s0=-0.1) "Other end of the spring";
    output PneumaticMuscle.Types.Length x = mass.s "Contraction";
  equation
    connect(muscle.flange_a, mass.flange_b);
    connect(spring.flange_b, mass.flange_a);
    connect(floor.flange, spring.flange_a);
    annotation (experiment(StopTime=4, Interval=0.01));
  end SpringDamper;

  model Controlled "The same, held at a contraction by a controller of standard blocks"
    extends Hung;
    Modelica.Mechanics.Translational.Components.Mass mass(
      m=2, s(start=0, fixed=true), v(start=0, fixed=true)) "Load";
    Modelica.Mechanics.Translational.Components.SpringDamper spring(c=4000, d=60, s_rel0=0.1)
      "Opposes the contraction";
    Modelica.Mechanics.Translational.Components.Fixed floor(s0=-0.1) "Other end of the spring";
    Modelica.Mechanics.Translational.Sensors.PositionSensor sensor "Measures the contraction";
    Modelica.Blocks.Sources.Ramp wanted(height=0.02, duration=1) "Contraction that is wanted";
    Modelica.Blocks.Math.Feedback difference "Of the wanted and the measured contraction";
    Modelica.Blocks.Continuous.PI controller(k=60, T=0.5, initType=Modelica.Blocks.Types.Init.InitialState)
      "Current of a valve";
    Modelica.Blocks.Nonlinear.Limiter fill(uMin=0, uMax=0.35) "Current of the inlet valve";
    Modelica.Blocks.Math.Gain opposite(k=-1) "Sign of the exhaust";
    Modelica.Blocks.Nonlinear.Limiter vent(uMin=0, uMax=0.35) "Current of the exhaust valve";
    output PneumaticMuscle.Types.Length x = mass.s "Contraction";
  equation
    connect(muscle.flange_a, mass.flange_b);
    connect(spring.flange_b, mass.flange_a);
    connect(floor.flange, spring.flange_a);
    connect(mass.flange_b, sensor.flange);
    connect(wanted.y, difference.u1);
    connect(sensor.s, difference.u2);
    connect(difference.y, controller.u);
    connect(controller.y, fill.u);
    connect(controller.y, opposite.u);
    connect(opposite.y, vent.u);
    connect(fill.y, valve.u_in);
    connect(vent.y, valve.u_out);
    annotation (experiment(StopTime=4, Interval=0.01));
  end Controlled;

  model Joint "A joint of rotation that two muscles turn against each other"
    extends PneumaticMuscle.Interfaces.Rig;
    parameter PneumaticMuscle.Types.Length r = 0.02 "Radius of the joint";
    parameter PneumaticMuscle.Types.Length x_0 = 0.01 "Contraction of both in the middle position";
    Modelica.Blocks.Sources.Constant pressure(k=207e3) "Gauge pressure of the supply";
    Modelica.Blocks.Sources.Constant little(k=0.25) "Current of the valves that keep a pressure";
    Modelica.Blocks.Sources.Constant none(k=0) "Current of the valve that stays shut";
    Modelica.Blocks.Sources.Step fill(height=0.35, startTime=0.5) "Current of the valve that fills the first muscle";
    PneumaticMuscle.Pneumatics.Components.Supply supply "Air supply";
    PneumaticMuscle.Pneumatics.Components.Atmosphere atmosphere "Outlet";
    PneumaticMuscle.Pneumatics.Components.ValvePair valve_1 "Valves of the first muscle";
    PneumaticMuscle.Pneumatics.Components.ValvePair valve_2 "Valves of the second muscle";
    PneumaticMuscle.Muscles.Components.Muscle muscle_1 "Turns forwards";
    PneumaticMuscle.Muscles.Components.Muscle muscle_2 "Turns back";
    PneumaticMuscle.Mechanics.Components.Fixed frame_1(s0=muscle_1.L0 - x_0);
    PneumaticMuscle.Mechanics.Components.Fixed frame_2(s0=muscle_2.L0 - x_0);
    Modelica.Mechanics.Rotational.Components.IdealGearR2T arm_1(ratio=1/r) "Arm of the first muscle";
    Modelica.Mechanics.Rotational.Components.IdealGearR2T arm_2(ratio=-1/r) "Arm of the second muscle";
    Modelica.Mechanics.Rotational.Components.Inertia forearm(
      J=2e-3, phi(start=0, fixed=true), w(start=0, fixed=true)) "What is turned";
    Modelica.Mechanics.Rotational.Components.Damper damper(d=0.02) "Friction of the joint";
    Modelica.Mechanics.Rotational.Components.Fixed frame "Its other side";
    output Real phi(unit="rad") = forearm.phi "Angle of the joint";
  equation
    connect(pressure.y, supply.p_gauge);
    connect(supply.port, valve_1.supply);
    connect(supply.port, valve_2.supply);
    connect(valve_1.exhaust, atmosphere.port);
    connect(valve_2.exhaust, atmosphere.port);
    connect(fill.y, valve_1.u_in);
    connect(none.y, valve_1.u_out);
    connect(little.y, valve_2.u_in);
    connect(little.y, valve_2.u_out);
    connect(valve_1.port, muscle_1.port);
    connect(valve_2.port, muscle_2.port);
    connect(frame_1.flange, muscle_1.flange_b);
    connect(frame_2.flange, muscle_2.flange_b);
    connect(muscle_1.flange_a, arm_1.flangeT);
    connect(muscle_2.flange_a, arm_2.flangeT);
    connect(arm_1.flangeR, forearm.flange_a);
    connect(arm_2.flangeR, forearm.flange_a);
    connect(forearm.flange_b, damper.flange_a);
    connect(damper.flange_b, frame.flange);
    annotation (experiment(StopTime=2, Interval=0.005));
  end Joint;

  model StandardWall "A wall of a heat capacity between two thermal conductors"
    extends PneumaticMuscle.Interfaces.Wall;
    parameter Modelica.Units.SI.HeatCapacity C = 40 "Heat capacity of the wall";
    Modelica.Thermal.HeatTransfer.Components.HeatCapacitor capacity(C=C, T(start=293.15, fixed=true));
    Modelica.Thermal.HeatTransfer.Components.Convection inner_film;
    Modelica.Thermal.HeatTransfer.Components.Convection outer_film;
  equation
    inner_film.Gc = h_film*A;
    outer_film.Gc = h_film*A;
    connect(heatPort, inner_film.solid);
    connect(inner_film.fluid, capacity.port);
    connect(capacity.port, outer_film.solid);
    connect(outer_film.fluid, outside);
  end StandardWall;

  model WarmWall "The muscle with the spring, whose wall is made of standard parts"
    extends SpringDamper(muscle(redeclare model Wall = StandardWall));
    output PneumaticMuscle.Types.Temperature T_wall = muscle.wall.capacity.T "Temperature of the wall";
  end WarmWall;
end StandardParts;
