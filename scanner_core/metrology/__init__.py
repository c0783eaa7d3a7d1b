"""What a measurement is worth: errors against a known truth, and the tests of a rig."""
