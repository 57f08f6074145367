"""What a checkout measures; never part of the product."""
