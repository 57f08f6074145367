"""What the algorithms share: the engine process, layers, inputs, words."""
