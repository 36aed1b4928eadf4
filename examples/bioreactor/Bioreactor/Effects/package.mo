within Bioreactor;
package Effects "Rates of growth and of other processes that the base model lacks"
end Effects;
