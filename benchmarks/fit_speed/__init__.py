"""A fit of six parameters by pam-cosim and by estim8 on the same FMU and data."""
