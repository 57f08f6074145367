"""The only place that knows files, blocks and steps at once."""
