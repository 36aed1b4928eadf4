within PneumaticMuscle;
package Sensors "What instruments read"
end Sensors;
