"""The virtual rig, a peer of the real drivers: specimens, scene, image formation, cameras and firmware."""
