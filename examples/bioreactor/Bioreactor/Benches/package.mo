within Bioreactor;
package Benches "Rigs: what is fed in, and what instruments read"
end Benches;
