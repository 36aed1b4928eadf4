model Unclosed "never ends
  Real x;
end Unclosed;
