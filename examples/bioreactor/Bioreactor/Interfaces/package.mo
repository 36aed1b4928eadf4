within Bioreactor;
package Interfaces "Connectors, and what effects and laws have in common"
end Interfaces;
