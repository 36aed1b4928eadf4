package Tanks "Two water tanks and a valve"
  type Level = Real(final quantity="Length", final unit="m", displayUnit="mm", min=0, nominal=0.5);
  constant Real g(unit="m/s2") = 9.81 "Gravity";

  connector Port
    Level h "Level";
    flow Real q(unit="m3/s") "Flow into the component";
  end Port;

  connector Signal = input Real;

  model Tank "A tank"
    Port port;
    parameter Real A(unit="m2", min=0.01, max=10) = 2 "Cross-section";
    parameter Level h_start = 1 "Level at the start";
    Level h(start=h_start, fixed=true) "Level";
  equation
    A*der(h) = port.q;
    port.h = h;
  end Tank;

  partial model TwoPorts
    Port a;
    Port b;
  equation
    a.q + b.q = 0;
  end TwoPorts;

  model Valve "Linear valve"
    extends TwoPorts;
    parameter Real k(unit="m2/s") = 0.3 "Conductance";
  equation
    a.q = k*(a.h - b.h);
  end Valve;

  model Bench "Two tanks that level out"
    Tank left(h_start=3) "Left tank";
    Tank right(A=left.A/2, h_start=0.5);
    Valve valve;
    input Real inflow(unit="m3/s", start=0) "Inflow";
    output Level h "Level of the left tank";
    Feed feed(q=inflow);
  equation
    connect(left.port, valve.a);
    connect(valve.b, right.port);
    connect(feed.port, left.port);
    h = left.h;
    annotation (experiment(StopTime=20, Interval=0.1, Tolerance=1e-7));
  end Bench;

  model Feed
    Port port;
    Signal q;
  equation
    port.q = -q;
  end Feed;

  model Switched "A second valve that a condition brings in"
    extends Bench;
    parameter Boolean second = false;
    Valve other(k=0.7) if second;
  equation
    connect(left.port, other.a);
    connect(other.b, right.port);
  end Switched;

  model SwitchedOn
    extends Switched(second=true);
  end SwitchedOn;

  model Short "Tanks joined without a resistance: one state, twice the level"
    Tank left(h_start=1);
    Tank right(A=3, h_start=1);
    Feed feed(q=0.5);
  equation
    connect(left.port, right.port);
    connect(feed.port, left.port);
  end Short;
end Tanks;
