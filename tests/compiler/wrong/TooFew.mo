model TooFew
  Real x(start=0, fixed=true);
  Real force;
equation
  der(x) = force;
end TooFew;
