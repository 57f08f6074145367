"""The paper's experiments, and its model as printed."""
