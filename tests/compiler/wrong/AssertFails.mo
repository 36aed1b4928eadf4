model AssertFails
  parameter Integer n = 0;
  Real x = 1;
equation
  assert(n > 0, "n must be positive");
end AssertFails;
