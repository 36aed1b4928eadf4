within PneumaticMuscle;
package Benches "Test rigs: what is driven, what is measured"
end Benches;
