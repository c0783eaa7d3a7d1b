"""The window: Qt only, no numerics; what it shows and does is the headless core's."""
