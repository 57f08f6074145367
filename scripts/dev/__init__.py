"""Tools of those who work on tetratrack: what is generated, packed, drawn and compared; never shipped."""
