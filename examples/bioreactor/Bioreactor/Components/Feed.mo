within Bioreactor.Components;
model Feed "A pump that feeds sterile medium"
  Interfaces.Broth broth "Liquid";
  parameter Real S_in(unit="kg/m3", min=0, max=1000) = 50 "Concentration of the substrate in the medium";
  input Real Q(unit="m3/s") "Volume flow";
equation
  broth.q = -Q;
  broth.m_S = -Q*S_in;
  broth.m_X = 0;
end Feed;
