within Bioreactor.Interfaces;
partial model Culture "The terminal of a culture: an effect that has it too is connected in parallel"
  Broth broth "Liquid";
end Culture;
