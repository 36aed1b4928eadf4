package Assertions "What models state of themselves"
  model Growing "x = k t, with something to say about it"
    parameter Real k = 1;
    input Real u(start=0);
    Real x(start=0, fixed=true);
    output Real y = x;
  equation
    assert(k > 0, "k must be positive");
    assert(x < 1, "above one", AssertionLevel.warning);
    assert(x < 2, "x = " + String(x, significantDigits=3) + " is not below 2 (k = " + String(k) + ")");
    assert(u < 5, "u is too large");
    der(x) = k;
  end Growing;

  model Silent "The same equations without a word"
    parameter Real k = 1;
    input Real u(start=0);
    Real x(start=0, fixed=true);
    output Real y = x;
  equation
    der(x) = k;
  end Silent;

  function checked "Has a condition in one of its branches"
    input Real x;
    output Real y;
  algorithm
    if x > 1 then
      assert(x < 2, "too large");
    end if;
    y := x;
  end checked;

  model InFunctions "Assertions in a function, in a branch that is taken late, and in parts"
    parameter Real late = 3;
    Real x(start=0, fixed=true);
    output Real y = if time > late then checked(x) else 0;
    Part part(v=x, limit=100);
  equation
    der(x) = 1;
  end InFunctions;

  model Part
    parameter Real limit = 1;
    Real v;
  equation
    assert(v < limit, "the part is full");
  end Part;

  model AtStart "What must hold at the start need not hold later"
    Real x(start=0, fixed=true);
    output Real y = x;
  initial equation
    assert(x < 0.5, "x starts too high");
  equation
    der(x) = 1;
  end AtStart;

  model Conditional "Assertions in the branches of an if-equation"
    parameter Integer structure = 1;
    Real x(start=0, fixed=true);
    output Real y;
  equation
    der(x) = 1;
    if x < 1 then
      y = 0;
    else
      assert(x < 1.5, "in the second branch");
      y = 1;
    end if;
    if structure == 2 then
      assert(x < 0.1, "of another structure");
    end if;
  end Conditional;

  model Algebraic "No states"
    input Real u(start=0);
    output Real y = 2*u;
  equation
    assert(y < 3, "y too large");
  end Algebraic;
end Assertions;
