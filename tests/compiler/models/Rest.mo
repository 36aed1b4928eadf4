package Rest "How states begin: fixed, at rest, or as nothing else says"
  type Dynamics = enumeration(DynamicFreeInitial "Guess", FixedInitial "Fixed", SteadyStateInitial "Steady");
  model Around
    parameter Dynamics dynamics = Dynamics.FixedInitial;
  end Around;

  model Tank "A law that no symbols solve, and what follows it"
    outer Around around;
    parameter Dynamics dynamics = around.dynamics annotation (Evaluate=true);
    parameter Real p_start = 1;
    parameter Real k = 1;
    input Real feed;
    Real p(start=p_start, fixed=dynamics == Dynamics.FixedInitial);
    Real q[2](each start=0, each fixed=dynamics == Dynamics.FixedInitial);
  initial equation
    if dynamics == Dynamics.SteadyStateInitial then
      der(p) = 0;
      0 = der(q[1]);
      2*der(q[2]) = 0;
    end if;
  equation
    der(p) = feed - k*p^3;
    der(q) = {p - q[1], q[1]^2 - q[2]};
  end Tank;

  model Plain
    inner Around around;
    input Real u(start=8);
    output Real y = tank.p;
    Tank tank(feed=u);
  end Plain;

  model Steady = Plain(around(dynamics=Dynamics.SteadyStateInitial));
  model Guess = Plain(around(dynamics=Dynamics.DynamicFreeInitial));

  model Two "One of two tanks begins at rest, fed by the other one"
    extends Plain(tank(dynamics=Dynamics.SteadyStateInitial, feed=u + second.p));
    Tank second(feed=u, p_start=19);
  end Two;

  model Leaning "Something begins where another is, which begins at rest beside it"
    extends Steady(tank(feed=u - z/10));
    Real z;
  initial equation
    z = tank.p^2;
  equation
    der(z) = tank.p - z;
  end Leaning;

  model Late "A parameter would have to be found with the rest"
    extends Steady;
    parameter Real z(fixed=false);
  initial equation
    z = tank.p;
  end Late;

  partial model Gas
    parameter Real V = 2;
    input Real u(start=3);
    Real p(start=5);
    Real T(start=300);
    Real m(stateSelect=StateSelect.always);
  initial equation
    der(p) = 0;
  equation
    p*V = m*T;
    der(p) = u - p;
    der(m) = u^3 - m^3;
  end Gas;

  model Made "What is at rest is no state: the mass is chosen"
    extends Gas;
  initial equation
    der(T) = 0;
  end Made;

  model Kept "A state without a start value: its guess follows from that of the temperature"
    extends Gas;
  initial equation
    der(m) = 0;
  end Kept;

  model Linear "What symbols solve"
    input Real u(start=3);
    parameter Real k = 2;
    Real x(start=1);
  initial equation
    der(x) = 0;
  equation
    der(x) = u - k*x;
  end Linear;

  model Nowhere "Nothing is ever at rest here"
    input Real u(start=8);
    Real x(start=1);
  initial equation
    der(x) = 0;
  equation
    der(x) = u + x^2;
  end Nowhere;

  model Hard "An initial equation that says something else, and that no symbols solve"
    Real x(start=1);
  initial equation
    x^3 + x = 3;
  equation
    der(x) = -x;
  end Hard;
end Rest;
