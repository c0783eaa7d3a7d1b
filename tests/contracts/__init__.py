"""Contracts: what every device of a kind promises, whoever drives it.

They run on everything that needs no hardware: the virtual rig, a firmware model behind a guarded serial port, recordings, a
stream, the emulation of an SDK.  On the devices of a rig file they run with::

    pytest -m hardware --rig RIG.toml

Tests that need a device on the table bear the marker ``hardware`` and are left out otherwise.  Before them: the laser's beam
must end on something matt, nobody may look into it, and the axes must be free to move.
"""
