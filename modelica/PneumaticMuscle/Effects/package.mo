within PneumaticMuscle;
package Effects "Physical effects that the base models leave out: the shelf from which a diagnosis picks"
end Effects;
