"""Set Impronta up and start it: the window, or without a display the whole job headless.

    python3 packaging/start.py                         the window on the virtual rig, or `impronta demo`
    python3 packaging/start.py demo --specimen ear     any subcommand of `impronta`
    python3 packaging/start.py --set-up-only           only the set-up

Needs nothing but Python; may be run again at any time.
"""

import sys


def main() -> int:
    if sys.version_info < (3, 11):
        sys.exit(
            f"Impronta needs Python 3.11 or newer, and this is {sys.version.split()[0]} ({sys.executable}). "
            f"Install a newer one and start this command with it, for example: python3.11 {sys.argv[0]}"
        )
    from launcher import start

    return start(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
