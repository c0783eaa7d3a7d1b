"""Are the reasons right?  Reconstructed surfaces against rays cast at the truth."""
