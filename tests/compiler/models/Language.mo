package Language "One construct of the language after the other"
  model Arrays "for-equations, vector equations, each, array parameters"
    parameter Integer n = 4;
    parameter Real tau[n] = {0.5, 1, 1.5, 2};
    parameter Real start = 2;
    Real x[n](each start=start, each fixed=true);
    Real y[2](start={1, 2}, each fixed=true);
    Real total = sum(x);
    Real weighted = tau*x;
    Real largest = max({x[i] for i in 1:n});
  equation
    tau[1]*der(x[1]) = -x[1];
    for i in 2:n loop
      tau[i]*der(x[i]) = x[i - 1] - x[i];
    end for;
    2*der(y) = {3, 4} - y;
  end Arrays;

  model World
    parameter Real g = 9.81;
  end World;

  model Ball
    outer World world;
    Real v(start=0, fixed=true);
  equation
    der(v) = -world.g;
  end Ball;

  model InnerOuter
    inner World world(g=1.62);
    Ball balls[2];
    parameter Real offset = 1;
  end InnerOuter;

  model NoInner
    Ball balls[2];
    Ball single;
  end NoInner;

  partial function Law
    input Real x;
    output Real y;
  end Law;

  function Straight
    extends Law;
  algorithm
    y := 2*x;
  end Straight;

  function Kinked "A local array, a loop and branches"
    extends Law;
    input Real a = 3;
  protected
    constant Integer n = 3;
    Real power[n];
    Real s = 0;
  algorithm
    power[1] := x;
    for i in 2:n loop
      power[i] := power[i - 1]*x;
    end for;
    for i in 1:n loop
      s := s + power[i];
    end for;
    if x > 1 then
      y := a*s;
    elseif x > 0 then
      y := a*x;
    else
      y := 0;
    end if;
  end Kinked;

  function Two "Two results"
    input Real x;
    output Real square = x^2;
    output Real cube;
  algorithm
    cube := x*square;
  end Two;

  model Element
    replaceable function f = Straight constrainedby Law;
    input Real u;
    Real y = f(u);
  end Element;

  model Functions
    input Real u;
    output Real y;
    output Real z;
    output Real square;
    output Real cube;
    Element plain(u=u);
    Element kinked(u=u, redeclare function f = Kinked(a=5));
  equation
    y = plain.y;
    z = kinked.y;
    (square, cube) = Two(u);
  end Functions;

  model NestedFunction "The function redeclared two levels down"
    extends Wrapped(element(redeclare function f = Kinked));
  end NestedFunction;

  model Wrapped
    input Real u;
    Element element(u=u);
  end Wrapped;

  type Shape = enumeration(cylinder "Round", box "Square");

  record Data
    parameter Real a = 1;
    parameter Real b = 2*a;
    parameter Shape shape = Shape.cylinder;
  end Data;

  record Big
    extends Data(a=10, shape=Shape.box);
  end Big;

  model Records
    parameter Data data = Big(b=5);
    replaceable parameter Data other;
    Real area = if data.shape == Shape.box then data.a^2 else 3*data.a^2;
    Real sum_ = other.a + other.b;
  end Records;

  model RedeclaredRecord
    extends Records(redeclare parameter Big other(a=4));
  end RedeclaredRecord;

  model Loop "Two springs in series, the node between them has no mass"
    parameter Real k1 = 10;
    parameter Real k2 = 30;
    Real x(start=1, fixed=true);
    Real v(start=0, fixed=true);
    Real node, f1, f2;
  equation
    f1 = k1*node;
    f2 = k2*(x - node);
    f1 = f2;
    der(x) = v;
    2*der(v) = -f2;
  end Loop;

  model Rigid "Two masses rigidly coupled: index 3"
    parameter Real m1 = 1;
    parameter Real m2 = 3;
    Real s1(start=0.5, fixed=true), s2, v1(start=0, fixed=true), v2, f;
  equation
    der(s1) = v1;
    der(s2) = v2;
    m1*der(v1) = -8*s1 + f;
    m2*der(v2) = -f;
    s2 = s1 + 1;
  end Rigid;

  model Initial "Start values by equations"
    parameter Real T0 = 300;
    Real m(start=2, fixed=true);
    Real U;
    Real T;
    Real steady;
  initial equation
    T = T0;
    der(steady) = 0;
  equation
    U = 700*m*T;
    der(m) = 0.1;
    der(U) = 10*(290 - T);
    der(steady) = T - 3*steady;
  end Initial;

  model Conditions "if-equations, if-expressions, time, der of an expression, noEvent and smooth"
    parameter Boolean fast = true;
    Real x(start=1, fixed=true);
    Real y;
    Real rate = der(x^2 + time);
  equation
    if fast then
      der(x) = -2*x;
    else
      der(x) = -x;
    end if;
    if time > 0.5 then
      y = noEvent(if x > 0.1 then 1 else 2);
    else
      y = smooth(1, max(x, 0.5));
    end if;
    assert(x > -1, "x is too small");
  end Conditions;

  model Chosen "stateSelect decides"
    Real a(stateSelect=StateSelect.never, start=1, fixed=true);
    Real b(stateSelect=StateSelect.prefer);
    Real rate;
  equation
    b = 2*a + 1;
    der(a) = -a;
    rate = der(b);
  end Chosen;

  model Lowpass
    input Real u;
    output Real y;
    parameter Real tau = 1;
  equation
    tau*der(y) = u - y;
  end Lowpass;

  model Algorithm
    input Real u;
    output Real y;
  algorithm
    y := u;
    for i in 1:3 loop
      y := y*u;
    end for;
  end Algorithm;

  model Parameters "What can be set from outside"
    parameter Real free = 1;
    parameter Real computed = 2*free;
    final parameter Real fixed_ = 3;
    parameter Integer count = 2;
    parameter Real constant_expression = 2*3;
    Lowpass inner_(tau=free, u=1);
    Lowpass other(final tau=5, u=1);
    Lowpass third(tau=6, u=1);
  protected
    parameter Real hidden = 4;
  end Parameters;

  connector Pin
    Real v;
    flow Real i;
  end Pin;

  model Resistor
    Pin p[2];
    parameter Real r = 1;
  equation
    p[1].i + p[2].i = 0;
    p[1].v - p[2].v = r*p[1].i;
  end Resistor;

  model Box "Outside connectors: the sum changes sign"
    Pin a;
    Pin b;
    Resistor chain[3](r={1, 2, 3});
  equation
    connect(a, chain[1].p[1]);
    for i in 1:2 loop
      connect(chain[i].p[2], chain[i + 1].p[1]);
    end for;
    connect(chain[3].p[2], b);
  end Box;

  model Source
    Pin p;
    parameter Real v;
  equation
    p.v = v;
  end Source;

  model Circuit
    Box box;
    Source battery(v=12);
    Source ground(v=0);
    Pin top "Open: no current";
    output Real current = box.a.i;
  equation
    connect(battery.p, box.a);
    connect(box.b, ground.p);
    top.v = 1;
  end Circuit;
end Language;
