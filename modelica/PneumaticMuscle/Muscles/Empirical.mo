within PneumaticMuscle.Muscles;
model Empirical "Muscle of Dzahir and Yamamoto with the gas that it encloses"
  extends Components.EmpiricalMuscle;
  extends Interfaces.RigMuscle(final x_start=elasticity.x_rest);
  parameter Real n(unit="1", min=1, max=1.4) = 1.2 "Polytropic exponent of the gas" annotation (Dialog(group="Gas"));
  replaceable model Gas = Laws.Gases.Sorge constrainedby Interfaces.Gas "Law of the gas"
    annotation (choicesAllMatching=true);
  outer Components.Ambient ambient "Surroundings";
  Gas gas(V=braid.V, n=n, p_start=ambient.p, T_start=ambient.T, p_reference=ambient.p, T_reference=ambient.T, h_film=0)
    "Gas in the bladder";
  Components.Fixed frame(s0=L0) "Where the muscle is fixed";
equation
  connect(port, gas.port);
  connect(flange_b, frame.flange);
  annotation (defaultComponentName="muscle", Documentation(info="<html>
<p><code>Components.EmpiricalMuscle</code>, DY (5)-(16). DY impose the pressure; that a valve or a regulator can feed the
muscle, it encloses a gas, DP (11), in the volume of its sleeve, without heat to a wall. The stretched sleeve carries the
load at the start, DY (12). Load and frequency of DY (10)-(11) are those of the rig; where the length is imposed
the load is taken as zero, and the friction that goes with it.</p>
</html>"));
end Empirical;
