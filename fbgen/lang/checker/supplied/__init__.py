"""What comes with a controller: standard functions and blocks, instructions, as tables."""
