within WindTunnel;
package Effects "Effects that the published models leave out"
end Effects;
