within PneumaticMuscle.Effects.ValveArea;
model UnequalAreas "The exhaust valve is larger or smaller than the inlet valve"
  extends Interfaces.ValveArea;
  extends FamilyMember(final absent="r=1");
  parameter Real r(unit="1", min=0.2, max=5, nominal=1) = 0.85 "Ratio of the areas of exhaust and inlet valve"
    annotation (Dialog(group="Effect"));
equation
  A[1] = C_A*Functions.openingArea(u[1]);
  A[2] = r*C_A*Functions.openingArea(u[2]);
  annotation (Documentation(info="<html>
<p>A_out = r A_in at one current. Source: <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (62) takes
both valves for equal and calibrates one of them by 30 %; typical of valves of one make are differences of 5 to 20
%.</p>
<p>Fingerprint: filling is right and venting too slow or too fast by one factor, or the other way round.</p>
</html>"));
end UnequalAreas;
