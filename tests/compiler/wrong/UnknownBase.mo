model UnknownBase
  extends Tanks.Benchh;
end UnknownBase;
