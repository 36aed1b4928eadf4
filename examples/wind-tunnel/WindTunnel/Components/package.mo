within WindTunnel;
package Components "Parts of the base model"
end Components;
