model UnknownClass
  Real y = 1;
  Tanks.Tnk tank;
end UnknownClass;
