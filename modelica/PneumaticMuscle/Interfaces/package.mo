within PneumaticMuscle;
package Interfaces "Connectors, and what a class must offer to stand in a certain place"
end Interfaces;
