within PneumaticMuscle;
package Components "Muscle, vessel, valves, load and their parts"
end Components;
