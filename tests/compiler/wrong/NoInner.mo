model NoInner
  Language.World world;
  Language.Ball ball;
end NoInner;
