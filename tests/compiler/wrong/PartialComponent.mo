model PartialComponent
  Tanks.TwoPorts thing;
end PartialComponent;
