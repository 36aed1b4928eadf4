within PneumaticMuscle.Muscles.Data;
record DMSP10 "Festo DMSP-10 and MAS-10, as measured on a DMSP-10-250"
  extends SleeveData(L0=0.25, D0=0.0136, alpha_0=28.5*Constants.pi/180, t_wall=1.8e-3);
  annotation (Documentation(info="<html>
<p>Inside diameter 10 mm, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo 2005</a>. Wall 1.8 mm,
angle of the fibres 28.6 deg with a correction of -0.1 deg, length 250 mm:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, known here through
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others 2026</a>, who use their numbers. The maker
publishes no angle. On which diameter the fibres lie is not published either: at the outside of the wall, 13.6 mm, the
cylinder, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), pulls 0.840 N/kPa at rest; Martens
and Boblan 2017 measure 0.892 in their Table A2; on the inside it would be 0.454. At 800 kPa, less the threshold of 21
kPa, it is 655 N; the maker says 630 N.</p>
</html>"));
end DMSP10;
