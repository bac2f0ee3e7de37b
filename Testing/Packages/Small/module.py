"""Nothing but a module."""
