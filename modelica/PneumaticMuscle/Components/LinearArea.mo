within PneumaticMuscle.Components;
model LinearArea "Effective area linear in the current above a threshold, DP (62)"
  extends Interfaces.ValveArea;
equation
  for i in 1:2 loop
    A[i] = C_A*Functions.openingArea(u[i]);
  end for;
end LinearArea;
