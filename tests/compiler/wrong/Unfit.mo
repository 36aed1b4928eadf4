model Unfit
  extends Muscles.Bench(muscle(redeclare model Gas = Tanks.Tank));
end Unfit;
