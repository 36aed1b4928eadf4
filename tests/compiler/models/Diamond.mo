package Diamond "One base class inherited along two ways"
  partial model Base
    Real x(start=1, fixed=true);
  equation
    der(x) = -x;
  end Base;

  partial model Left
    extends Base;
    Real left = 2*x;
  end Left;

  partial model Right
    extends Base;
    Real right = 3*x;
  end Right;

  model Both
    extends Left;
    extends Right;
  end Both;

  connector RealInput = input Real;
  connector RealOutput = output Real;

  model Signals "Connectors that are signals, at the top and inside"
    RealInput u;
    RealOutput y(unit="V");
    Gain gain(k=3);
  equation
    connect(u, gain.u);
    connect(gain.y, y);
  end Signals;

  model Gain
    RealInput u;
    RealOutput y;
    parameter Real k = 1;
  equation
    y = k*u;
  end Gain;
end Diamond;
