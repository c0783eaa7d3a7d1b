"""Set Impronta up with its tests and run them, under a virtual display where the system has one.

    python3 packaging/check.py                 style, types and the `ci` tests
    python3 packaging/check.py -m long         soaks; every argument goes to pytest
    python3 packaging/check.py -m bench        benchmarks
    python3 packaging/check.py --lint tests/core       style and types first, then these tests

Needs nothing but Python; may be run again at any time. Exit code 0 when everything passed.
"""

import sys


def main() -> int:
    if sys.version_info < (3, 11):
        sys.exit(
            f"Impronta needs Python 3.11 or newer, and this is {sys.version.split()[0]} ({sys.executable}). "
            f"Install a newer one and start this command with it, for example: python3.11 {sys.argv[0]}"
        )
    from launcher import check

    return check(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
