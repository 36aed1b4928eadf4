model NoValue
  parameter Real k;
  Real x = k;
end NoValue;
