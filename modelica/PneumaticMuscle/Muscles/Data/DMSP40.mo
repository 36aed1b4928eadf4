within PneumaticMuscle.Muscles.Data;
record DMSP40 "Festo DMSP-40 and MAS-40, from the force that the maker states"
  extends SleeveData(L0=0.4, D0=0.0472, alpha_0=28.6*Constants.pi/180, t_wall=3.6e-3);
  annotation (Documentation(info="<html>
<p>Inside diameter 40 mm and up to 6000 N, <a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Festo 2005</a>;
no measurement of its fibres was found. Derived: with the angle of the smaller ones, 28.6 deg,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">Martens and Boblan 2017</a>, Gaylord's pull,
<a href=\"modelica://PneumaticMuscle.UsersGuide.References\">DP</a> (1), is 6000 N at 600 kPa if the fibres lie on 47.2
mm, which leaves 3.6 mm for the wall. That the maker means 600 kPa is taken from the size's usual limit. The length is
an example.</p>
</html>"));
end DMSP40;
