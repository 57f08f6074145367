"""The units as an armour: how they are placed, and how the structure lies to its design."""
