"""Cases of the blind score: which effects are hidden in which runs on which bench. They import nothing of pam-cosim."""
