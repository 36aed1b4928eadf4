within PneumaticMuscle.UsersGuide;
class References "Sources, cited by equation number throughout"
  annotation (Documentation(info="<html>
<ul>
<li>DP: M. D. Doumit, S. Pardoel, <i>Dynamic contraction behaviour of pneumatic artificial muscle</i>, Mechanical Systems and
Signal Processing 91 (2017) 93-110.</li>
<li>DY: M. A. M. Dzahir, S. Yamamoto, <i>Dynamic modeling of McKibben muscle using empirical model and particle swarm
optimization method</i>, Applied Sciences 9 (2019) 2538.</li>
<li>AM: <i>Modeling and control of a pneumatic air muscle actuator</i>, slides.</li>
</ul>
<p>Where a printed equation could not be used as it stands, the class that implements it says what was changed and
why; <code>docs/validation.md</code> lists all of them.</p>
</html>"));
end References;
