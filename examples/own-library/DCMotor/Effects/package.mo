within DCMotor;
package Effects "Effects that the base model lacks"
end Effects;
