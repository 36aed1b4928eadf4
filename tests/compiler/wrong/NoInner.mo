model NoInner
  Language.Ball ball;
end NoInner;
