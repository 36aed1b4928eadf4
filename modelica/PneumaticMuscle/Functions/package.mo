within PneumaticMuscle;
package Functions "Laws that several components use"
end Functions;
