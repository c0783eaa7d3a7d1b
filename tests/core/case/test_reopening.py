"""A complete scan is taken up again."""

from __future__ import annotations
