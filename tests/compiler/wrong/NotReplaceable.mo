model NotReplaceable
  model A
    model B = Tanks.Valve;
    B b;
  end A;
  A a(redeclare model B = Tanks.Tank);
end NotReplaceable;
