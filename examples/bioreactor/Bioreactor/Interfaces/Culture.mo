within Bioreactor.Interfaces;
partial model Culture "The terminal of a culture: an effect that has it too lies beside the culture"
  Broth broth "Liquid";
end Culture;
