within PneumaticMuscle.Effects.ValveArea;
model LeakingSeat "The inlet valve does not shut fully"
  extends Interfaces.ValveArea;
  extends FamilyMember(final absent="A_seat=0");
  parameter Types.Area A_seat(min=0, max=2.5e-7, nominal=5e-9) = 5e-9 "Effective area of the leaking seat"
    annotation (Dialog(group="Effect"));
equation
  A[1] = C_A*Functions.openingArea(u[1]) + A_seat;
  A[2] = C_A*Functions.openingArea(u[2]);
  annotation (Documentation(info="<html>
<p>A_in = A(u_in) + A_seat. Source: the seat leakage that data sheets of valves state; a notch, or dirt on the seat, is
an orifice beside it, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (40)-(42). That of the exhaust
valve is <a href=\"modelica://PneumaticMuscle.Effects.Leak.OrificeLeak\">OrificeLeak</a>. Typical 1e-10 to 1e-8 m2.</p>
<p>Fingerprint: the pressure rises while both valves are shut, towards the supply, and venting ends above ambient
pressure: behind 207 kPa and an exhaust of 0.26 mm2 by 0.1 kPa at 5e-9 m2, by 0.3 kPa at 1e-8 m2.</p>
</html>"));
end LeakingSeat;
