model DelayInFunction
  function late
    input Real u;
    output Real y;
  algorithm
    y := delay(u, 0.1);
  end late;
  input Real u;
  Real y = late(u);
end DelayInFunction;
