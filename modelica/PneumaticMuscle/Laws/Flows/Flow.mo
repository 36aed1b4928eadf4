within PneumaticMuscle.Laws.Flows;
partial model Flow "What a law of flow must offer"
  extends Interfaces.TwoGasPorts;
  extends Icons.Orifice;
  input Types.Area A "Effective area";
  annotation (Documentation(info="<html>
<p>Left to the extending class: the equation of m_flow.</p>
</html>"));
end Flow;
