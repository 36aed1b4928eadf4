//! base 0.1.0
package 'Flat'
  type 'Types.Law' = enumeration('linear', 'square');

  function 'Functions.flow'
    input Real 'p';
    output Real 'q';
    constant Real 'k' = 2.0;
  algorithm
    'q' := 'k' * 'p';
  end 'Functions.flow';

  model 'Flat' "A vessel that empties, as a tool flattens it"
    parameter Real 'vessel.V'(min = 0.1, unit = "m3") = 2.0 "Volume";
    final parameter 'Types.Law' 'law' = 'Types.Law'.'linear';
    Real 'vessel.p'(start = 4.0, fixed = true, unit = "Pa") "Pressure";
    Real[2] 'half.q'(unit = {"m3/s", "m3/s"});
    output Real 'p'(unit = "Pa") "Pressure";
  equation
    'half.q'[1] = (if 'law' == 'Types.Law'.'linear' then 0.5 else 0.0) * 'Functions.flow'('vessel.p');
    'half.q'[2] = 'half.q'[1];
    'vessel.V' * der('vessel.p') = -('half.q'[1] + 'half.q'[2]);
    'p' = 'vessel.p';
    annotation(experiment(StopTime = 3));
  end 'Flat';
end 'Flat';
