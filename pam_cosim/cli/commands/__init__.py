"""The commands, one file each; ``cli`` gives them their names."""
