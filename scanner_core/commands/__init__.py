"""The headless command line: one file a subcommand.

Every command is a function of its parsed arguments and a :class:`~scanner_core.commands.console.Console`; it returns
the exit code and prints through the console, so that ``--json`` gives one object on standard output and nothing else.
"""
