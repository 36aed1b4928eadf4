package Start "Parameters that initial equations determine"
  model Late "An input that is felt after a dead time, and not before"
    parameter Real T(min=0) = 0.5;
    input Real u(start=0);
    output Real y = if time > t_0 + T then delay(u, T) else 0;
    output Real before = if time - t_0 <= 2*T then 1 else 0;
    output Real after = delay(if t_0 < time - T then 3 else 2, T);
    Real x(start=0, fixed=true);
  protected
    parameter Real t_0(fixed=false);
  initial equation
    t_0 = time;
  equation
    der(x) = y;
  end Late;

  model Steady "A parameter for which the start is at rest"
    parameter Real k = 2;
    parameter Real q(fixed=false);
    parameter Real twice = 2*q;
    Real x(start=3, fixed=true);
    output Real y = q + twice;
    output Real switched = if time > q then 1 else 0;
  initial equation
    der(x) = 0;
  equation
    der(x) = q - k*x;
  end Steady;
end Start;
