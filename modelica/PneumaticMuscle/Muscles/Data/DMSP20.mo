within PneumaticMuscle.Muscles.Data;
record DMSP20 "Festo DMSP-20 and MAS-20, as measured on a DMSP-20-300"
  extends SleeveData(L0=0.296, D0=0.0236, alpha_0=28.527*Constants.pi/180, t_wall=1.8e-3);
  annotation (Documentation(info="<html>
<p>Inside diameter 20 mm, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo 2005</a>. Wall 1.8 mm,
angle 28.6 deg with a correction of -0.073 deg, length at rest 296 mm:
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a> and their Table A1, known here
through <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Bolen and others 2026</a>. As in DMSP10 the fibres
are taken at the outside of the wall, 23.6 mm: the cylinder,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), pulls 2.524 N/kPa at rest, Table A1 has 2.609.
At 600 kPa, less the threshold of 34 kPa, it is 1428 N; Table A1 has 1460 N, the maker says 1500 N.</p>
</html>"));
end DMSP20;
