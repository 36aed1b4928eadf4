within Bioreactor.Benches;
model FedBatch "A culture that is fed, with samples of its substrate"
  input Real Q_in(unit="m3/s", start=0) "Feed";
  output Real C_S(unit="kg/m3") "Concentration of the substrate";
  Components.Feed feed(Q=Q_in) "Pump";
  Components.Vessel vessel "Vessel";
  Components.Cells cells "Culture";
equation
  connect(feed.broth, vessel.broth);
  connect(cells.broth, vessel.broth);
  C_S = vessel.S;
  annotation (experiment(StopTime=54000, Interval=600));
end FedBatch;
