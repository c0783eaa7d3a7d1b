"""Controllers under load and in trouble: ``python -m tests.bench.controllers lines`` and ``events``, on any port or on our model."""
