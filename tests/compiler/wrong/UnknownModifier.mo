model UnknownModifier
  extends Tanks.Bench(
    left(AA=3));
end UnknownModifier;
