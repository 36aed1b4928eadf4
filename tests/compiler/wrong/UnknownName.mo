model UnknownName
  Real x = 2*velocity;
end UnknownName;
