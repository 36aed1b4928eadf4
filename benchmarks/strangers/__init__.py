"""The score of strangers' rigs: three to six departures at once, by the protocol in refsim/strangers/PROTOCOL.md."""
