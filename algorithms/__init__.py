"""Processing algorithms: one a module; each starts the engine in its own process and never computes itself."""
