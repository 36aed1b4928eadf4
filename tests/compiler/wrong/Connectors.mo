model Connectors
  Tanks.Tank tank;
  Muscles.Source source(m_flow=0);
equation
  connect(tank.port, source.port);
end Connectors;
