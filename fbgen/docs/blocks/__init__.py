"""What the pages of blocks say, read from their trees: nothing of it is written a second time."""
