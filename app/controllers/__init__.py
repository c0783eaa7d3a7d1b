"""One QObject per activity: they start the core's runners and jobs, and tell the views what came of it."""
