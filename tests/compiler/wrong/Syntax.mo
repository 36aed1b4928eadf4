model Syntax
  Real x;
equation
  der(x) = -x
  x = 3;
end Syntax;
