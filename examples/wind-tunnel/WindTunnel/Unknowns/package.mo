within WindTunnel;
package Unknowns "Terms without a law, to be estimated as signals from a measurement"
end Unknowns;
