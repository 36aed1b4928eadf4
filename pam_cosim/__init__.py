"""pam-cosim: from a measurement of a pneumatic muscle to the physical effect its model lacks."""
