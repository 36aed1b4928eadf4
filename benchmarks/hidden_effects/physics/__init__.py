"""Forms of hidden effects that the reference rig's own list lacks; `table` says which set uses which."""
