package Muscles "A gas volume with a wall that moves, and gases to choose from"
  constant Real R = 287.05;

  connector Port
    Real p;
    flow Real m_flow;
  end Port;

  partial model PartialGas
    Port port;
    input Real V;
    parameter Real n = 1 "Exponent";
    parameter Real p_start;
    Real p(start=p_start, fixed=true, nominal=1e5, unit="Pa");
    Real T;
  equation
    port.p = p;
  end PartialGas;

  model Polytropic "Temperature follows pressure"
    extends PartialGas;
  equation
    T = 293.15*(p/p_start)^((n - 1)/n);
    V*der(p) = -n*p*der(V) + n*R*T*port.m_flow;
  end Polytropic;

  model Energetic "Mass and energy balance, one state more"
    extends PartialGas(T(start=293.15, fixed=true));
    parameter Real h = 3 "Heat transfer";
    Real m;
  equation
    der(m) = port.m_flow;
    p*V = m*R*T;
    V*der(p) = -1.4*p*der(V) + 0.4*h*(293.15 - T) + 1.4*R*293.15*port.m_flow;
  end Energetic;

  model Muscle
    parameter Real L0 = 0.3 "Length";
    parameter Real b = sqrt(L0^2 + 0.01) "Fibre length, computed";
    parameter Real m = 2;
    parameter Real p_start = 2e5;
    replaceable model Gas = Polytropic constrainedby PartialGas(p_start=p_start) "Gas";
    Port port;
    Gas gas(V=V, n=1.3);
    Real V;
    Real L = L0 - x;
    Real x(start=0.01, fixed=true, unit="m");
    Real v(start=0, fixed=true);
  equation
    V = L*(b^2 - L^2)/10;
    der(x) = v;
    m*der(v) = (gas.p - 1e5)*(3*L^2 - b^2)/10 - 2e4*x - 300*v;
    connect(gas.port, port);
  end Muscle;

  model Source
    Port port;
    input Real m_flow;
  equation
    port.m_flow = -m_flow;
  end Source;

  model Bench
    input Real m_flow;
    output Real x;
    Source source(m_flow=m_flow);
    Muscle muscle;
  equation
    connect(source.port, muscle.port);
    x = muscle.x;
  end Bench;

  model Redeclared "The gas redeclared two levels down, with a parameter"
    extends Bench(muscle(redeclare model Gas = Energetic(h=5), L0=0.25));
  end Redeclared;

  model Redeclared3 "One level more, in a component"
    Bench bench(muscle(redeclare model Gas = Energetic(h=k)), m_flow=0);
    parameter Real k = 7;
  end Redeclared3;

  model RedeclaredInBody
    model Stiff
      extends Muscle;
      redeclare model Gas = Energetic(h=6);
    end Stiff;
    Source source(m_flow=0);
    Stiff muscle;
  equation
    connect(source.port, muscle.port);
  end RedeclaredInBody;

  model ReplaceableComponent
    replaceable Polytropic gas(n=1.3) constrainedby PartialGas(V=0.01, p_start=3e5, n=1.25);
    Source source(m_flow=0);
  equation
    connect(source.port, gas.port);
  end ReplaceableComponent;

  model RedeclaredComponent
    extends ReplaceableComponent(redeclare Energetic gas(h=9));
  end RedeclaredComponent;

  model RedeclaredAgain "The outermost redeclaration counts"
    extends Redeclared(muscle(redeclare model Gas = Polytropic, m=4));
  end RedeclaredAgain;

  model ModifiedClass "A modification of the redeclared class itself, and of a component of it"
    extends Redeclared(muscle(Gas(h=8), gas(n=1.1)));
  end ModifiedClass;

  model ModifiedComponent
    extends RedeclaredComponent(gas(h=3));
  end ModifiedComponent;
end Muscles;
