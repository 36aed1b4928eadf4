within Bioreactor.Components;
model Vessel "A stirred vessel"
  Interfaces.Broth broth "Liquid";
  parameter Real S_start(unit="kg/m3", min=0, max=500) = 1 "Concentration of the substrate at the start";
  parameter Real X_start(unit="kg/m3", min=0, max=500) = 1 "Concentration of the biomass at the start";
  parameter Real V_start(unit="m3", min=1e-6, max=1000) = 7e-3 "Volume at the start";
  Real V(unit="m3", start=V_start, fixed=true) "Volume";
  Real S(unit="kg/m3", start=S_start, fixed=true) "Concentration of the substrate";
  Real X(unit="kg/m3", start=X_start, fixed=true) "Concentration of the biomass";
equation
  broth.V = V;
  broth.S = S;
  broth.X = X;
  der(V) = broth.q;
  V*der(S) + S*broth.q = broth.m_S "d(V S)/dt";
  V*der(X) + X*broth.q = broth.m_X "d(V X)/dt";
end Vessel;
